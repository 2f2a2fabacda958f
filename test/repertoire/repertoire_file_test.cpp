#include "repertoire/repertoire_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "fixtures.h"
#include "repertoire/repertoire_writer.h"
#include "repertoire/sqlite.h"

namespace hexapod {
namespace {

void expectEqual(const Pose2& a, const Pose2& b) {
  EXPECT_EQ(a.x_m, b.x_m);
  EXPECT_EQ(a.y_m, b.y_m);
  EXPECT_EQ(a.yaw_rad, b.yaw_rad);
}

void expectEqual(const Entry& a, const Entry& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.genome, b.genome);
  expectEqual(a.end_pose, b.end_pose);
  EXPECT_EQ(a.cost, b.cost);
  EXPECT_EQ(a.evaluation, b.evaluation);
  ASSERT_EQ(a.execution.has_value(), b.execution.has_value());
  if (!a.execution) return;
  expectEqual(a.execution->mean, b.execution->mean);
  EXPECT_EQ(a.execution->spread_m, b.execution->spread_m);
  EXPECT_EQ(a.execution->spread_rad, b.execution->spread_rad);
  EXPECT_EQ(a.execution->trials, b.execution->trials);
  EXPECT_EQ(a.execution->falls, b.execution->falls);
}

void expectEqual(const Repertoire& a, const Repertoire& b) {
  EXPECT_EQ(a.run_id, b.run_id);
  EXPECT_EQ(a.robot_id, b.robot_id);
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.generation, b.generation);
  EXPECT_EQ(a.evaluations, b.evaluations);
  EXPECT_EQ(a.behavior_duration_s, b.behavior_duration_s);
  EXPECT_EQ(a.joint_names, b.joint_names);
  EXPECT_EQ(a.options, b.options);
  EXPECT_EQ(a.facts, b.facts);
  ASSERT_EQ(a.entries.size(), b.entries.size());
  for (std::size_t i = 0; i < a.entries.size(); ++i) expectEqual(a.entries[i], b.entries[i]);
  ASSERT_EQ(a.history.size(), b.history.size());
  for (std::size_t i = 0; i < a.history.size(); ++i) {
    EXPECT_EQ(a.history[i].evaluations, b.history[i].evaluations);
    EXPECT_EQ(a.history[i].archive_size, b.history[i].archive_size);
    EXPECT_EQ(a.history[i].sparseness_m, b.history[i].sparseness_m);
    EXPECT_EQ(a.history[i].median_orientation_error_rad, b.history[i].median_orientation_error_rad);
    EXPECT_EQ(a.history[i].max_reach_m, b.history[i].max_reach_m);
    EXPECT_EQ(a.history[i].elapsed_s, b.history[i].elapsed_s);
    ASSERT_EQ(a.history[i].held_out.has_value(), b.history[i].held_out.has_value());
    if (!a.history[i].held_out) continue;
    EXPECT_EQ(a.history[i].held_out->sparseness_m, b.history[i].held_out->sparseness_m);
    EXPECT_EQ(a.history[i].held_out->median_orientation_error_rad,
              b.history[i].held_out->median_orientation_error_rad);
    EXPECT_EQ(a.history[i].held_out->median_shift_m, b.history[i].held_out->median_shift_m);
  }
  ASSERT_EQ(a.trials.size(), b.trials.size());
  for (std::size_t i = 0; i < a.trials.size(); ++i) {
    EXPECT_EQ(a.trials[i].evaluation, b.trials[i].evaluation);
    EXPECT_EQ(a.trials[i].genome, b.trials[i].genome);
    expectEqual(a.trials[i].simulated, b.trials[i].simulated);
    EXPECT_EQ(a.trials[i].cost, b.trials[i].cost);
    ASSERT_EQ(a.trials[i].measured.has_value(), b.trials[i].measured.has_value());
    if (a.trials[i].measured) expectEqual(*a.trials[i].measured, *b.trials[i].measured);
  }
}

/// Something of everything a learner keeps; the archive is not in the order of ids.
LearnerState sampleState() {
  LearnerState state;
  state.values = {{"random", "1 2 3"}, {"blob", std::string("a\0b\xff", 4)}, {"none", ""}};
  state.population = {{3, 3, {0, 1, 2, 3}, {Verdict::kSelfCollided, {}, 0.0}, 2, 0.1, 1},
                      {5,
                       4,
                       {200, 1, 2, 3},
                       {Verdict::kWalked, {0.1, -0.2, 3.0}, 0.3},
                       0,
                       std::numeric_limits<double>::infinity(),
                       3}};
  Entry entry;
  for (const std::int64_t id : {9, 4}) {
    entry.id = id;
    entry.genome = {static_cast<std::uint8_t>(id), 1};
    entry.end_pose = {1.0 / 3.0, -0.2, 0.1};
    entry.cost = 0.2;
    entry.evaluation = id + 1;
    state.archive.push_back(entry);
  }
  state.dropped = {4};
  return state;
}

TEST(RepertoireFile, GivesBackWhatWasSavedToTheLastBit) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.db");
  const LearnerState state = sampleState();
  saveRepertoire(file, sampleRepertoire(), state);
  const StoredRepertoire stored = loadStoredRepertoire(file);
  expectEqual(stored.repertoire, sampleRepertoire());
  EXPECT_EQ(digestOf(stored.learner_state), digestOf(state));
  EXPECT_EQ(stored.learner_state.values, state.values);
  EXPECT_EQ(stored.learner_state.dropped, state.dropped);
  ASSERT_EQ(stored.learner_state.population.size(), 2U);
  EXPECT_EQ(stored.learner_state.population[1].diversity, state.population[1].diversity);
  EXPECT_EQ(stored.learner_state.population[0].outcome.verdict, Verdict::kSelfCollided);
  ASSERT_EQ(stored.learner_state.archive.size(), 2U);
  EXPECT_EQ(stored.learner_state.archive[0].id, 9);
  expectEqual(loadRepertoire(file), sampleRepertoire());
}

TEST(RepertoireFile, AnEmptyRepertoireIsAValidFile) {
  const TemporaryFolder folder;
  saveRepertoire(folder.file("a.db"), Repertoire{});
  expectEqual(loadRepertoire(folder.file("a.db")), Repertoire{});
}

TEST(RepertoireFile, KeepsTheSignAndSizeOfExtremeNumbers) {
  const TemporaryFolder folder;
  Repertoire repertoire = sampleRepertoire(1);
  repertoire.entries[0].end_pose = {-0.0, 5e-324, -1.7976931348623157e308};
  repertoire.entries[0].cost = 2.0;
  saveRepertoire(folder.file("a.db"), repertoire);
  expectEqual(loadRepertoire(folder.file("a.db")), repertoire);
}

TEST(RepertoireFile, RowsDoNotDependOnTheOrderOfTheEntriesNorOnTheLocale) {
  const TemporaryFolder folder;
  saveRepertoire(folder.file("plain.db"), sampleRepertoire());
  Repertoire reversed = sampleRepertoire();
  std::reverse(reversed.entries.begin(), reversed.entries.end());
  const CommaLocale comma;
  saveRepertoire(folder.file("other.db"), reversed);
  expectEqual(loadRepertoire(folder.file("other.db")), sampleRepertoire());
  SqliteDatabase database(folder.file("plain.db"), SqliteDatabase::Mode::kRead);
  database.execute("ATTACH '" + folder.file("other.db") + "' AS other");
  for (const std::string table : {"entries", "meta", "history", "trials"}) {
    EXPECT_EQ(database.integer("SELECT count(*) FROM (SELECT * FROM main." + table +
                               " EXCEPT SELECT * FROM other." + table + ")"),
              0)
        << table;
  }
}

TEST(RepertoireFile, TellsTheOrientationErrorOfTheStoredPoseBesideTheCost) {
  const TemporaryFolder folder;
  Repertoire repertoire = sampleRepertoire(1);
  repertoire.entries[0].end_pose = {0.5, 0.0, 0.25};  // straight ahead: the arc arrives with 0
  repertoire.entries[0].cost = 0.75;
  saveRepertoire(folder.file("a.db"), repertoire);
  SqliteDatabase database(folder.file("a.db"), SqliteDatabase::Mode::kRead);
  EXPECT_EQ(database.integer("SELECT count(*) FROM entries WHERE orientation_error_rad = 0.25 AND "
                             "cost = 0.75"),
            1);
}

TEST(RepertoireFile, OfVersion1IsReadWithItsOrientationErrorAsCost) {
  const TemporaryFolder folder;
  saveRepertoire(folder.file("a.db"), sampleRepertoire());
  SqliteDatabase database(folder.file("a.db"), SqliteDatabase::Mode::kWrite);
  database.execute(
      "CREATE TABLE old AS SELECT id, genome, x_m, y_m, yaw_rad, cost AS orientation_error_rad, "
      "evaluation, executed_x_m, executed_y_m, executed_yaw_rad, spread_m, spread_rad, trials, "
      "falls FROM entries; DROP TABLE entries; ALTER TABLE old RENAME TO entries; "
      "PRAGMA user_version = 1");
  expectEqual(loadRepertoire(folder.file("a.db")), sampleRepertoire());
}

TEST(RepertoireFile, OfAProgramThatKnewNoTrialsHasNone) {
  const TemporaryFolder folder;
  Repertoire repertoire = sampleRepertoire();
  repertoire.trials.clear();
  saveRepertoire(folder.file("a.db"), repertoire);
  SqliteDatabase(folder.file("a.db"), SqliteDatabase::Mode::kWrite).execute("DROP TABLE trials");
  expectEqual(loadRepertoire(folder.file("a.db")), repertoire);
}

TEST(RepertoireFile, CanBeReadWithOrdinaryTools) {
  const TemporaryFolder folder;
  saveRepertoire(folder.file("a.db"), sampleRepertoire(3), sampleState());
  SqliteDatabase database(folder.file("a.db"), SqliteDatabase::Mode::kRead);
  EXPECT_EQ(database.integer("PRAGMA application_id"), kApplicationId);
  EXPECT_EQ(database.integer("PRAGMA user_version"), kFormatVersion);
  EXPECT_EQ(database.integer("SELECT count(*) FROM entries WHERE length(genome) = 24"), 3);
  EXPECT_EQ(database.integer("SELECT count(*) FROM entries WHERE executed_x_m IS NULL"), 2);
  EXPECT_EQ(database.integer("SELECT value FROM meta WHERE key = 'option.seed'"), 11);
  EXPECT_EQ(database.integer("SELECT count(*) FROM history"), 2);
  EXPECT_EQ(database.integer("SELECT count(*) FROM population WHERE verdict = 'self-collided'"), 1);
  EXPECT_EQ(database.integer("SELECT id FROM archive WHERE dropped"), 4);
}

TEST(RepertoireFile, IsCompleteAloneOnceTheWriterIsGone) {
  const TemporaryFolder folder;
  saveRepertoire(folder.file("a.db"), sampleRepertoire());
  std::vector<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(folder.file(""))) {
    names.push_back(file.path().filename().string());
  }
  EXPECT_EQ(names, std::vector<std::string>{"a.db"});
}

TEST(RepertoireFile, LoadingChangesNothing) {
  const TemporaryFolder folder;
  saveRepertoire(folder.file("a.db"), sampleRepertoire());
  const std::string before = contentOf(folder.file("a.db"));
  loadRepertoire(folder.file("a.db"));
  EXPECT_EQ(contentOf(folder.file("a.db")), before);
}

TEST(RepertoireFile, DigestTellsEveryChangeOfAnEntryButNotTheirOrder) {
  std::vector<Entry> entries = sampleRepertoire().entries;
  const std::string digest = digestOf(entries);
  std::reverse(entries.begin(), entries.end());
  EXPECT_EQ(digestOf(entries), digest);
  auto changed = entries;
  changed[0].genome[5] ^= 1;
  EXPECT_NE(digestOf(changed), digest);
  changed = entries;
  changed[0].end_pose.yaw_rad = std::nextafter(changed[0].end_pose.yaw_rad, 10.0);
  EXPECT_NE(digestOf(changed), digest);
  changed = entries;
  changed[0].execution->falls += 1;
  EXPECT_NE(digestOf(changed), digest);
  changed = entries;
  changed.pop_back();
  EXPECT_NE(digestOf(changed), digest);
}

TEST(GeneLevels, OfAnyNumberAreKept) {
  const TemporaryFolder folder;
  for (const std::uint64_t levels : {9u, 101u, 253u, 256u}) {
    Random random(5);
    Repertoire saved = sampleRepertoire();
    saved.options["gene_levels"] = std::to_string(levels);
    for (Entry& entry : saved.entries) {
      for (auto& level : entry.genome) level = static_cast<std::uint8_t>(random.below(levels));
    }
    saveRepertoire(folder.file("levels.db"), saved, {});
    const Repertoire loaded = loadRepertoire(folder.file("levels.db"));
    expectEqual(loaded, saved);
    EXPECT_EQ(loaded.geneLevels(), levels);
  }
}

}  // namespace
}  // namespace hexapod
