#include "study/run_recorder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "evolution/analytic_evaluator.h"

namespace hexapod {
namespace {

std::vector<std::string> linesOf(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

Method mapElites() { return makeMethod("map_elites", 24, {}, Random(1)); }

/// Files of MAP-Elites with the stand-in after so many candidates.
class RecordedRun {
 public:
  explicit RecordedRun(std::int64_t evaluations)
      : folder_(std::filesystem::path(testing::TempDir()) /
                ("recorded_" + std::to_string(::getpid()) + "_" + std::to_string(evaluations))) {
    std::filesystem::create_directories(folder_);
    AnalyticEvaluator evaluator;
    const Method method = mapElites();
    const EvolutionCounters& counters = method.algorithm->counters();
    RunRecorder recorder(folder_.string());
    while (counters.evaluations < evaluations) {
      advance(*method.algorithm, evaluator, evaluations - counters.evaluations);
      recorder.record(method, 2 * counters.evaluations, 0.0);
    }
    recorder.finish(method, 2 * evaluations, 0.0);
    entries_of_method = method.repertoires().at("map_elites").size();
  }
  ~RecordedRun() { std::filesystem::remove_all(folder_); }

  std::vector<std::string> history() const { return linesOf(folder_ / "history.csv"); }
  std::vector<std::string> entries() const { return linesOf(folder_ / "entries.csv"); }

  std::size_t entries_of_method = 0;

 private:
  std::filesystem::path folder_;
};

TEST(RunRecorder, MarksDependOnTheCandidatesAlone) {
  EXPECT_EQ(historyMark(499), 0);
  EXPECT_EQ(historyMark(1700), 1500);
  EXPECT_EQ(historyMark(99999), 99500);
  EXPECT_EQ(historyMark(123456), 120000);
  EXPECT_EQ(snapshotMark(9999), 0);
  EXPECT_EQ(snapshotMark(10000), 10000);
  EXPECT_EQ(snapshotMark(99999), 30000);
  EXPECT_EQ(snapshotMark(1000000), 1000000);
}

TEST(RunRecorder, ALongRunBeginsLikeAShortOne) {
  const auto shorter = RecordedRun(2000).history();
  const auto longer = RecordedRun(4000).history();
  ASSERT_EQ(shorter.size(), 5u);  // header; 500, 1000, 1500, 2000
  ASSERT_EQ(longer.size(), 9u);
  for (std::size_t i = 0; i < shorter.size(); ++i) EXPECT_EQ(shorter[i], longer[i]);
}

TEST(RunRecorder, WritesTheLastStateWhereverItIs) {
  const RecordedRun run(1230);
  EXPECT_EQ(run.history().back().substr(0, 21), "map_elites,1230,2460,");
  EXPECT_EQ(run.entries().size(), 1 + run.entries_of_method);
  EXPECT_EQ(run.entries().back().substr(0, 16), "map_elites,1230,");
}

TEST(RunRecorder, TellsOfAFolderItCannotWriteTo) {
  const Method method = mapElites();
  RunRecorder recorder("/nowhere/at/all");
  EXPECT_THROW(recorder.finish(method, 0, 0.0), std::runtime_error);
}

}  // namespace
}  // namespace hexapod
