#include "repertoire/repertoire_writer.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <system_error>

#include "common/text.h"
#include "repertoire/learner_tables.h"
#include "repertoire/repertoire_rows.h"
#include "repertoire/typed_rows.h"

namespace hexapod {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTables =
    "CREATE TABLE IF NOT EXISTS entries("
    "id INTEGER PRIMARY KEY, genome TEXT NOT NULL, x_m REAL NOT NULL, y_m REAL NOT NULL, "
    "yaw_rad REAL NOT NULL, orientation_error_rad REAL NOT NULL, cost REAL NOT NULL, "
    "evaluation INTEGER NOT NULL, "
    "executed_x_m REAL, executed_y_m REAL, executed_yaw_rad REAL, spread_m REAL, spread_rad REAL, "
    "trials INTEGER NOT NULL, falls INTEGER NOT NULL);"
    "CREATE TABLE IF NOT EXISTS meta(key TEXT PRIMARY KEY, value TEXT NOT NULL);"
    "CREATE TABLE IF NOT EXISTS history("
    "evaluations INTEGER NOT NULL, archive_size INTEGER NOT NULL, sparseness_m REAL NOT NULL, "
    "median_orientation_error_rad REAL NOT NULL, max_reach_m REAL NOT NULL, "
    "elapsed_s REAL NOT NULL, held_out_sparseness_m REAL, "
    "held_out_median_orientation_error_rad REAL, held_out_median_shift_m REAL);"
    "CREATE TABLE IF NOT EXISTS trials("
    "evaluation INTEGER NOT NULL, genome TEXT NOT NULL, x_m REAL NOT NULL, y_m REAL NOT NULL, "
    "yaw_rad REAL NOT NULL, cost REAL NOT NULL, measured_x_m REAL, measured_y_m REAL, "
    "measured_yaw_rad REAL);"
    "DELETE FROM entries; DELETE FROM meta; DELETE FROM history; DELETE FROM trials;";

std::size_t geneCount(const Repertoire& repertoire) {
  if (!repertoire.entries.empty()) return repertoire.entries.front().genome.size();
  return repertoire.trials.empty() ? 0 : repertoire.trials.front().genome.size();
}

void requireSavable(const Repertoire& repertoire) {
  std::set<std::int64_t> ids;
  std::set<Genome> genomes;
  const GenomeShape shape{geneCount(repertoire), repertoire.geneLevels()};
  for (const Entry& entry : repertoire.entries) {
    std::string problem = problemOf(entry, shape);
    if (problem.empty() && !ids.insert(entry.id).second) problem = "occurs twice";
    if (problem.empty() && !entry.genome.empty() && !genomes.insert(entry.genome).second) {
      problem = "has the genome " + toString(entry.genome) + " of another entry";
    }
    if (problem.empty()) continue;
    throw std::invalid_argument("The repertoire cannot be saved: entry " +
                                std::to_string(entry.id) + " " + problem + ".");
  }
  for (const RobotTrial& trial : repertoire.trials) {
    const std::string problem = problemOf(trial, shape);
    if (problem.empty()) continue;
    throw std::invalid_argument("The repertoire cannot be saved: the trial of " +
                                toString(trial.genome) + " " + problem + ".");
  }
}

std::map<std::string, std::string> metaOf(const Repertoire& repertoire,
                                          const LearnerState& learner_state) {
  std::string joint_names;
  for (const std::string& name : repertoire.joint_names) {
    joint_names += (joint_names.empty() ? "" : ",") + name;
  }
  std::map<std::string, std::string> meta{
      {"format_version", std::to_string(kFormatVersion)},
      {"package_version", PACKAGE_VERSION},
      {"run_id", repertoire.run_id},
      {"robot_id", repertoire.robot_id},
      {"seed", std::to_string(repertoire.seed)},
      {"generation", std::to_string(repertoire.generation)},
      {"evaluations", std::to_string(repertoire.evaluations)},
      {"behavior_duration_s", exactText(repertoire.behavior_duration_s)},
      {"joint_names", joint_names},
      {"gene_count", std::to_string(geneCount(repertoire))},
      {"digest", digestOf(repertoire.entries)},
  };
  for (const auto& [name, value] : repertoire.options) meta[kOptionPrefix + name] = value;
  for (const auto& [name, value] : repertoire.facts) meta[kFactPrefix + name] = value;
  if (!repertoire.trials.empty()) meta[kTrialDigestKey] = digestOf(repertoire.trials);
  meta[kFileDigestKey] = digestOf(meta, repertoire.history, learner_state);
  return meta;
}

void bindExecution(const Entry& entry, SqliteStatement& insert) {
  if (!entry.execution) {
    for (int parameter = 8; parameter <= 12; ++parameter) insert.bindNull(parameter);
    for (int parameter = 13; parameter <= 14; ++parameter) insert.bind(parameter, std::int64_t{0});
    return;
  }
  const Execution& execution = *entry.execution;
  bindPose(8, execution.mean, insert);
  insert.bind(11, execution.spread_m);
  insert.bind(12, execution.spread_rad);
  insert.bind(13, static_cast<std::int64_t>(execution.trials));
  insert.bind(14, static_cast<std::int64_t>(execution.falls));
}

void insertEntries(const std::vector<Entry>& entries, SqliteDatabase& database) {
  SqliteStatement insert(database, std::string("INSERT INTO entries(") + kEntryColumns +
                                       ") VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
  for (const Entry& entry : entries) {
    insert.bind(1, entry.id);
    insert.bind(2, toString(entry.genome));
    bindPose(3, entry.end_pose, insert);
    insert.bind(6, entry.cost);
    insert.bind(7, entry.evaluation);
    bindExecution(entry, insert);
    insert.bind(15, entry.orientationErrorRad());
    insert.run();
  }
}

void bindHeldOut(const HistoryRow& row, SqliteStatement& insert) {
  if (!row.held_out) {
    for (int parameter = 7; parameter <= 9; ++parameter) insert.bindNull(parameter);
    return;
  }
  insert.bind(7, row.held_out->sparseness_m);
  insert.bind(8, row.held_out->median_orientation_error_rad);
  insert.bind(9, row.held_out->median_shift_m);
}

void insertHistory(const std::vector<HistoryRow>& history, SqliteDatabase& database) {
  SqliteStatement insert(database, std::string("INSERT INTO history(") + kHistoryColumns +
                                       ") VALUES (?,?,?,?,?,?,?,?,?)");
  for (const HistoryRow& row : history) {
    insert.bind(1, row.evaluations);
    insert.bind(2, row.archive_size);
    insert.bind(3, row.sparseness_m);
    insert.bind(4, row.median_orientation_error_rad);
    insert.bind(5, row.max_reach_m);
    insert.bind(6, row.elapsed_s);
    bindHeldOut(row, insert);
    insert.run();
  }
}

void insertTrials(const std::vector<RobotTrial>& trials, SqliteDatabase& database) {
  SqliteStatement insert(database, std::string("INSERT INTO trials(") + kTrialColumns +
                                       ") VALUES (?,?,?,?,?,?,?,?,?)");
  for (const RobotTrial& trial : trials) {
    insert.bind(1, trial.evaluation);
    insert.bind(2, toString(trial.genome));
    bindPose(3, trial.simulated, insert);
    insert.bind(6, trial.cost);
    if (trial.measured) {
      bindPose(7, *trial.measured, insert);
    } else {
      for (int parameter = 7; parameter <= 9; ++parameter) insert.bindNull(parameter);
    }
    insert.run();
  }
}

void insertMeta(const std::map<std::string, std::string>& meta, SqliteDatabase& database) {
  SqliteStatement insert(database, "INSERT INTO meta(key, value) VALUES (?,?)");
  for (const auto& [key, value] : meta) {
    insert.bind(1, key);
    insert.bind(2, value);
    insert.run();
  }
}

/// Throws unless the path can become, or is, a file of ours; creates the folders it lies in.
void preparePlace(const fs::path& path) {
  if (path.filename().empty()) {
    throw std::runtime_error("The repertoire file needs a name, not the folder '" + path.string() +
                             "'.");
  }
  std::error_code error;
  const fs::file_status status = fs::symlink_status(path, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    throw std::runtime_error("The repertoire file " + path.string() +
                             " is a link, a folder or a device: name an ordinary file.");
  }
  if (fs::exists(status) && fs::hard_link_count(path, error) > 1) {
    throw std::runtime_error("The repertoire file " + path.string() +
                             " has other names, too (hard links), under which another process may "
                             "be writing it: copy it and name the copy.");
  }
  fs::create_directories(path.parent_path(), error);
  if (error) {
    throw std::runtime_error("The folder " + path.parent_path().string() +
                             " of the repertoire file cannot be created: " + error.message() + ".");
  }
}

/// True when the database is a repertoire, false when it is empty; throws when it is anything else.
bool isRepertoire(SqliteDatabase& database, const std::string& file) {
  if (database.integer("PRAGMA page_count") == 0) return false;
  const std::int64_t application = database.integer("PRAGMA application_id");
  const std::int64_t version = database.integer("PRAGMA user_version");
  if (application != kApplicationId) {
    throw std::runtime_error("The file " + file +
                             " is another program's SQLite database and is not overwritten: move "
                             "it away or choose another repertoire file.");
  }
  if (version < kOldestWrittenVersion || version > kFormatVersion) {
    throw std::runtime_error("The repertoire file " + file + " has format version " +
                             std::to_string(version) + ", this program writes version " +
                             std::to_string(kFormatVersion) +
                             ": move it away or choose another repertoire file.");
  }
  return true;
}

/// The digest that the file of a repertoire claims to have.
std::string claimedDigest(SqliteDatabase& database) {
  SqliteStatement digest(
      database, std::string("SELECT value FROM meta WHERE key = '") + kFileDigestKey + "'");
  return digest.step() ? digest.bytes(0) : "";
}

}  // namespace

RepertoireWriter::RepertoireWriter(const std::string& file) {
  if (file.empty()) throw std::runtime_error("The name of the repertoire file is empty.");
  file_ = fs::absolute(file).string();
  open();
}

RepertoireWriter::~RepertoireWriter() {
  database_.reset();
  if (!created_ || holds_repertoire_ || !(stampOf(file_) == stamp_)) return;
  std::error_code ignored;  // an empty file is left, then
  fs::remove(file_, ignored);
}

void RepertoireWriter::open() {
  preparePlace(file_);
  database_.reset();
  if (lock_ && !lock_->isCurrent()) lock_.reset();
  if (!lock_) lock_ = std::make_unique<FileLock>(file_);
  try {
    if (!stamp_) created_ = !stampOf(file_);
    database_ = std::make_unique<SqliteDatabase>(file_, SqliteDatabase::Mode::kCreate);
    holds_repertoire_ = isRepertoire(*database_, file_);
    if (!stamp_ && holds_repertoire_) digest_ = claimedDigest(*database_);
    if (!stamp_) stamp_ = stampOf(file_);
  } catch (const SqliteError& error) {
    throw std::runtime_error("The file " + file_ +
                             " cannot be used as repertoire file: " + error.what() +
                             ". It is left as it is; choose another file or move it away.");
  }
}

void RepertoireWriter::save(const Repertoire& repertoire, const LearnerState& learner_state) {
  requireSavable(repertoire);
  try {
    requireOwnFile();
    write(repertoire, learner_state);
  } catch (const SqliteError& error) {
    throw std::runtime_error("The repertoire file " + file_ + " cannot be written: " +
                             error.what() + ". It keeps what was saved before.");
  }
  holds_repertoire_ = true;
}

void RepertoireWriter::requireOwnFile() {
  const std::optional<FileStamp> now = stampOf(file_);
  if (!now) stamp_.reset();  // removed or moved away: another one is begun
  if (database_ && now && now == stamp_) return;
  open();
  if (!holds_repertoire_ || claimedDigest(*database_) == digest_) return;
  database_.reset();
  throw std::runtime_error("The repertoire file " + file_ +
                           " was replaced or written by somebody else while this process was "
                           "working, and is not overwritten: move it away.");
}

void RepertoireWriter::write(const Repertoire& repertoire, const LearnerState& learner_state) {
  SqliteTransaction transaction(*database_, SqliteTransaction::Kind::kWrite);
  database_->execute("PRAGMA application_id = " + std::to_string(kApplicationId));
  database_->execute("PRAGMA user_version = " + std::to_string(kFormatVersion));
  database_->execute(kTables);
  database_->execute(kLearnerTables);
  insertEntries(repertoire.entries, *database_);
  const std::map<std::string, std::string> meta = metaOf(repertoire, learner_state);
  insertMeta(meta, *database_);
  insertHistory(repertoire.history, *database_);
  insertTrials(repertoire.trials, *database_);
  insertLearnerState(learner_state, *database_);
  transaction.commit();
  stamp_ = stampOf(file_);
  digest_ = meta.at(kFileDigestKey);
}

void saveRepertoire(const std::string& file, const Repertoire& repertoire,
                    const LearnerState& learner_state) {
  RepertoireWriter(file).save(repertoire, learner_state);
}

}  // namespace hexapod
