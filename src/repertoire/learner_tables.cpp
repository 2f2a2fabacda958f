#include "repertoire/learner_tables.h"

#include <array>

#include "repertoire/digest.h"
#include "repertoire/sound_database.h"
#include "repertoire/typed_rows.h"

namespace hexapod {
namespace {

constexpr std::array<Verdict, 4> kVerdicts = {Verdict::kWalked, Verdict::kFell,
                                              Verdict::kSelfCollided, Verdict::kDiverged};
constexpr const char* kPopulationColumns =
    "id, evaluation, genotype, verdict, x_m, y_m, yaw_rad, cost, rank, diversity, looks";
constexpr const char* kArchiveColumns = "id, genome, x_m, y_m, yaw_rad, cost, evaluation, dropped";

Verdict verdictFrom(const std::string& text) {
  for (const Verdict verdict : kVerdicts) {
    if (text == toString(verdict)) return verdict;
  }
  fail("a verdict in the table population", "'" + text + "'");
}

void insertPopulation(const std::vector<KeptIndividual>& population, SqliteDatabase& database) {
  SqliteStatement insert(database, std::string("INSERT INTO population(") + kPopulationColumns +
                                       ") VALUES (?,?,?,?,?,?,?,?,?,?,?)");
  for (const KeptIndividual& individual : population) {
    insert.bind(1, individual.id);
    insert.bind(2, individual.evaluation);
    insert.bind(3, toString(individual.genotype));
    insert.bind(4, toString(individual.outcome.verdict));
    bindPose(5, individual.outcome.end_pose, insert);
    insert.bind(8, individual.outcome.cost);
    insert.bind(9, individual.rank);
    insert.bind(10, individual.diversity);
    insert.bind(11, individual.looks);
    insert.run();
  }
}

void insertArchive(const LearnerState& state, SqliteDatabase& database) {
  SqliteStatement insert(database, std::string("INSERT INTO archive(") + kArchiveColumns +
                                       ") VALUES (?,?,?,?,?,?,?,?)");
  for (const Entry& entry : state.archive) {
    insert.bind(1, entry.id);
    insert.bind(2, toString(entry.genome));
    bindPose(3, entry.end_pose, insert);
    insert.bind(6, entry.cost);
    insert.bind(7, entry.evaluation);
    insert.bind(8, static_cast<std::int64_t>(state.dropped.count(entry.id)));
    insert.run();
  }
}

std::vector<KeptIndividual> readPopulation(SqliteDatabase& database) {
  requireCount(database, "population");
  std::vector<KeptIndividual> population;
  SqliteStatement rows(
      database, std::string("SELECT ") + kPopulationColumns + " FROM population ORDER BY rowid");
  const std::string name = "the table population";
  while (rows.step()) {
    KeptIndividual individual;
    individual.id = integerAt(rows, 0, name);
    individual.evaluation = integerAt(rows, 1, name);
    individual.genotype = genomeAt(rows, 2, name);
    individual.outcome = {verdictFrom(rows.bytes(3)), poseAt(rows, 4, name), realAt(rows, 7, name)};
    individual.rank = integerAt(rows, 8, name);
    individual.diversity = realAt(rows, 9, name);
    individual.looks = integerAt(rows, 10, name);
    population.push_back(std::move(individual));
  }
  return population;
}

void readArchive(SqliteDatabase& database, LearnerState& state) {
  requireCount(database, "archive");
  SqliteStatement rows(database,
                       std::string("SELECT ") + kArchiveColumns + " FROM archive ORDER BY rowid");
  const std::string name = "the table archive";
  while (rows.step()) {
    Entry entry;
    entry.id = integerAt(rows, 0, name);
    entry.genome = genomeAt(rows, 1, name);
    entry.end_pose = poseAt(rows, 2, name);
    entry.cost = realAt(rows, 5, name);
    entry.evaluation = integerAt(rows, 6, name);
    if (integerAt(rows, 7, name) != 0) state.dropped.insert(entry.id);
    state.archive.push_back(std::move(entry));
  }
}

}  // namespace

const char* const kLearnerTables =
    "CREATE TABLE IF NOT EXISTS state(key TEXT PRIMARY KEY, value BLOB NOT NULL);"
    "CREATE TABLE IF NOT EXISTS population("
    "id INTEGER NOT NULL, evaluation INTEGER NOT NULL, genotype TEXT NOT NULL, "
    "verdict TEXT NOT NULL, x_m REAL NOT NULL, y_m REAL NOT NULL, yaw_rad REAL NOT NULL, "
    "cost REAL NOT NULL, rank INTEGER NOT NULL, diversity REAL NOT NULL, looks INTEGER NOT NULL);"
    "CREATE TABLE IF NOT EXISTS archive("
    "id INTEGER NOT NULL, genome TEXT NOT NULL, x_m REAL NOT NULL, y_m REAL NOT NULL, "
    "yaw_rad REAL NOT NULL, cost REAL NOT NULL, evaluation INTEGER NOT NULL, "
    "dropped INTEGER NOT NULL);"
    "DELETE FROM state; DELETE FROM population; DELETE FROM archive;";

std::string digestOf(const LearnerState& state) {
  Digest digest;
  add(state, digest);
  return digest.text();
}

void add(const LearnerState& state, Digest& digest) {
  for (const auto& [key, value] : state.values) {
    digest.add(key);
    digest.add(value);
  }
  for (const KeptIndividual& individual : state.population) {
    for (const std::int64_t value :
         {individual.id, individual.evaluation, individual.rank, individual.looks}) {
      digest.add(value);
    }
    digest.add(toString(individual.genotype));
    digest.add(toString(individual.outcome.verdict));
    digest.add(individual.outcome.end_pose);
    digest.add(individual.outcome.cost);
    digest.add(individual.diversity);
  }
  for (const Entry& entry : state.archive) {
    digest.add(entry.id);
    digest.add(toString(entry.genome));
    digest.add(entry.end_pose);
    digest.add(entry.cost);
    digest.add(entry.evaluation);
    digest.add(static_cast<std::int64_t>(state.dropped.count(entry.id)));
  }
}

void insertLearnerState(const LearnerState& state, SqliteDatabase& database) {
  SqliteStatement insert(database, "INSERT INTO state(key, value) VALUES (?,?)");
  for (const auto& [key, value] : state.values) {
    insert.bind(1, key);
    insert.bindBlob(2, value);
    insert.run();
  }
  insertPopulation(state.population, database);
  insertArchive(state, database);
}

LearnerState readLearnerState(SqliteDatabase& database) {
  LearnerState state;
  state.values = readPairs(database, "state");
  if (database.integer("PRAGMA user_version") < kLearnerTablesVersion) return state;
  state.population = readPopulation(database);
  readArchive(database, state);
  return state;
}

std::map<std::string, std::string> readPairs(SqliteDatabase& database, const std::string& table) {
  requireCount(database, table);
  std::map<std::string, std::string> pairs;
  SqliteStatement rows(database, "SELECT key, value FROM " + table);
  while (rows.step()) {
    if (!rows.isText(0) || !(rows.isText(1) || rows.isBlob(1))) {
      fail("texts in the table " + table, "another type");
    }
    pairs[rows.bytes(0)] = rows.bytes(1);
  }
  return pairs;
}

}  // namespace hexapod
