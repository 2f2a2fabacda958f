#include "repertoire/repertoire_file.h"

#include <filesystem>
#include <set>
#include <stdexcept>

#include "common/text.h"
#include "repertoire/learner_tables.h"
#include "repertoire/repertoire_rows.h"
#include "repertoire/sound_database.h"
#include "repertoire/sqlite.h"
#include "repertoire/typed_rows.h"

namespace hexapod {
namespace {

namespace fs = std::filesystem;
using Meta = std::map<std::string, std::string>;

std::string metaText(const Meta& meta, const std::string& key) {
  const auto found = meta.find(key);
  if (found == meta.end()) fail("a row '" + key + "' in the table meta", "none");
  return found->second;
}

template <typename Number>
Number metaNumber(const Meta& meta, const std::string& key,
                  std::optional<Number> (*read)(const std::string&)) {
  const std::string text = metaText(meta, key);
  const std::optional<Number> number = read(text);
  if (!number) fail("a number as '" + key + "' in the table meta", "'" + text + "'");
  return *number;
}

std::map<std::string, std::string> withPrefix(const Meta& meta, const std::string& prefix) {
  std::map<std::string, std::string> found;
  for (const auto& [key, value] : meta) {
    if (key.compare(0, prefix.size(), prefix) == 0) found[key.substr(prefix.size())] = value;
  }
  return found;
}

std::vector<std::string> splitAtCommas(const std::string& text) {
  std::vector<std::string> parts;
  if (text.empty()) return parts;
  std::size_t begin = 0;
  for (std::size_t comma = 0; comma != std::string::npos; begin = comma + 1) {
    comma = text.find(',', begin);
    parts.push_back(text.substr(begin, comma - begin));
  }
  return parts;
}

std::optional<Execution> executionAt(const SqliteStatement& row, const std::string& name) {
  const std::int64_t trials = integerAt(row, 12, name);
  const std::int64_t falls = integerAt(row, 13, name);
  if (row.isNull(7)) return std::nullopt;
  if (trials > kMaxEntries || falls > kMaxEntries || trials < 0 || falls < 0) {
    fail("a sensible number of trials of " + name, std::to_string(trials));
  }
  return Execution{poseAt(row, 7, name), realAt(row, 10, name), realAt(row, 11, name),
                   static_cast<int>(trials), static_cast<int>(falls)};
}

Entry entryAt(const SqliteStatement& row, const GenomeShape& shape) {
  Entry entry;
  entry.id = integerAt(row, 0, "an entry");
  const std::string name = "entry " + std::to_string(entry.id);
  entry.genome = genomeAt(row, 1, name);
  entry.end_pose = poseAt(row, 2, name);
  entry.cost = realAt(row, 5, name);
  entry.evaluation = integerAt(row, 6, name);
  entry.execution = executionAt(row, name);
  const std::string problem = problemOf(entry, shape);
  if (!problem.empty()) fail("usable entries", name + ", which " + problem);
  return entry;
}

std::vector<Entry> readEntries(SqliteDatabase& database, const GenomeShape& shape) {
  requireCount(database, "entries");
  std::vector<Entry> entries;
  std::set<std::int64_t> ids;
  std::set<Genome> genomes;
  const bool is_version_1 = database.integer("PRAGMA user_version") == 1;
  SqliteStatement rows(database, std::string("SELECT ") +
                                     (is_version_1 ? kEntryColumnsOfVersion1 : kEntryColumns) +
                                     " FROM entries ORDER BY id");
  while (rows.step()) {
    entries.push_back(entryAt(rows, shape));
    const Entry& entry = entries.back();
    const std::string name = "entry " + std::to_string(entry.id);
    if (!ids.insert(entry.id).second) fail("every id once", name + " twice");
    if (!entry.genome.empty() && !genomes.insert(entry.genome).second) {
      fail("every genome once", toString(entry.genome) + " again in " + name);
    }
  }
  return entries;
}

RobotTrial trialAt(const SqliteStatement& row, const GenomeShape& shape) {
  const std::string name = "a trial";
  RobotTrial trial;
  trial.evaluation = integerAt(row, 0, name);
  trial.genome = genomeAt(row, 1, name);
  trial.simulated = poseAt(row, 2, name);
  trial.cost = realAt(row, 5, name);
  if (!row.isNull(6)) trial.measured = poseAt(row, 6, name);
  const std::string problem = problemOf(trial, shape);
  if (!problem.empty()) fail("usable trials", "one, which " + problem);
  return trial;
}

/// Files in which nothing was tried on a robot need not have the table.
std::vector<RobotTrial> readTrials(SqliteDatabase& database, const GenomeShape& shape) {
  std::vector<RobotTrial> trials;
  if (database.integer("SELECT count(*) FROM sqlite_master WHERE type = 'table' AND name = "
                       "'trials'") == 0) {
    return trials;
  }
  requireCount(database, "trials");
  SqliteStatement rows(database,
                       std::string("SELECT ") + kTrialColumns + " FROM trials ORDER BY rowid");
  while (rows.step()) trials.push_back(trialAt(rows, shape));
  return trials;
}

std::optional<HeldOut> heldOutAt(const SqliteStatement& row, const std::string& name) {
  if (row.isNull(6)) return std::nullopt;
  return HeldOut{realAt(row, 6, name), realAt(row, 7, name), realAt(row, 8, name)};
}

std::vector<HistoryRow> readHistory(SqliteDatabase& database) {
  requireCount(database, "history");
  std::vector<HistoryRow> history;
  SqliteStatement rows(database,
                       std::string("SELECT ") + kHistoryColumns + " FROM history ORDER BY rowid");
  const std::string name = "the table history";
  while (rows.step()) {
    history.push_back({integerAt(rows, 0, name), integerAt(rows, 1, name), realAt(rows, 2, name),
                       realAt(rows, 3, name), realAt(rows, 4, name), realAt(rows, 5, name),
                       heldOutAt(rows, name)});
  }
  return history;
}

void requireDigest(const Meta& meta, const std::string& key, const std::string& content,
                   const std::string& digest) {
  const std::string stored = metaText(meta, key);
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
  return;  // a fuzzer would get no further
#endif
  if (stored != digest) {
    fail(content + " with the digest " + stored, digest + ": the file was damaged or edited");
  }
}

StoredRepertoire read(SqliteDatabase& database, const std::string& path) {
  const SqliteTransaction transaction(database, SqliteTransaction::Kind::kRead);
  requireOurFormat(database);
  requireWhole(database, path);
  const Meta meta = readPairs(database, "meta");
  const std::int64_t genes = metaNumber(meta, "gene_count", integerFromText);
  if (genes < 0 || genes > kMaxGenes) {
    fail("genomes of up to " + std::to_string(kMaxGenes) + " genes", std::to_string(genes));
  }
  StoredRepertoire stored;
  stored.learner_state = readLearnerState(database);
  Repertoire& repertoire = stored.repertoire;
  repertoire.history = readHistory(database);
  repertoire.options = withPrefix(meta, kOptionPrefix);
  const GenomeShape shape{static_cast<std::size_t>(genes), repertoire.geneLevels()};
  repertoire.entries = readEntries(database, shape);
  repertoire.trials = readTrials(database, shape);
  requireDigest(meta, "digest", "entries", digestOf(repertoire.entries));
  if (!repertoire.trials.empty() || meta.count(kTrialDigestKey) > 0) {
    requireDigest(meta, kTrialDigestKey, "trials", digestOf(repertoire.trials));
  }
  requireDigest(meta, kFileDigestKey, "meta, history and state",
                digestOf(meta, repertoire.history, stored.learner_state));
  repertoire.run_id = metaText(meta, "run_id");
  repertoire.robot_id = metaText(meta, "robot_id");
  repertoire.seed = metaNumber(meta, "seed", unsignedFromText);
  repertoire.generation = metaNumber(meta, "generation", integerFromText);
  repertoire.evaluations = metaNumber(meta, "evaluations", integerFromText);
  repertoire.behavior_duration_s = metaNumber(meta, "behavior_duration_s", doubleFromText);
  repertoire.joint_names = splitAtCommas(metaText(meta, "joint_names"));
  repertoire.facts = withPrefix(meta, kFactPrefix);
  return stored;
}

}  // namespace

StoredRepertoire loadStoredRepertoire(const std::string& file) {
  const std::string name = "The repertoire file '" + file + "' cannot be used: ";
  try {
    if (file.empty()) fail("the name of a file", "an empty text");
    const std::string path = fs::absolute(file).string();
    requireSqliteFile(path);
    return read(*openDatabase(path), path);
  } catch (const SqliteError& error) {
    throw std::runtime_error(name + "expected an intact repertoire, found " +
                             describeDamage(file, error.what()) +
                             ". Restore a copy, or learn it again.");
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(name + error.what() + ".");
  }
}

Repertoire loadRepertoire(const std::string& file) { return loadStoredRepertoire(file).repertoire; }

LearnerState loadLearnerState(const std::string& file) {
  return loadStoredRepertoire(file).learner_state;
}

}  // namespace hexapod
