#include "learning/learning_session.h"

#include <filesystem>
#include <stdexcept>

#include <gtest/gtest.h>

#include "repertoire/repertoire_file.h"
#include "robot/load_robot.h"

namespace hexapod {
namespace {

namespace fs = std::filesystem;

class LearningSessionTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / "hexapod_learning_test";
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  LearnOptions smallRun(const std::string& name) const {
    LearnOptions options;
    options.repertoire_file = (folder_ / name).string();
    options.evolution.population_size = 10;
    options.evaluations = 55;  // five generations and a half
    options.validation_trials = 2;
    return options;
  }

  double now() { return time_s_ += 0.5; }

  bool learn(const LearnOptions& options, const LearningSession::Hooks& hooks = {}) {
    return LearningSession(robot_, options, [this] { return now(); }).run(hooks);
  }

  const RobotDescription robot_ = loadRobot("urdf/hexapod.urdf", "config/hexapod.yaml");
  fs::path folder_;
  double time_s_ = 0.0;
};

void expectSameEntries(const Repertoire& a, const Repertoire& b) {
  ASSERT_EQ(a.entries.size(), b.entries.size());
  EXPECT_EQ(digestOf(a.entries), digestOf(b.entries));
  EXPECT_EQ(a.run_id, b.run_id);
}

TEST_F(LearningSessionTest, StoresAValidatedRepertoireOfExactlyItsBudget) {
  const LearnOptions options = smallRun("a.db");
  ASSERT_TRUE(learn(options));
  const Repertoire repertoire = loadRepertoire(options.repertoire_file);
  EXPECT_EQ(repertoire.evaluations, 55);
  EXPECT_EQ(repertoire.robot_id, robot_.digest);
  EXPECT_EQ(repertoire.joint_names, robot_.jointNames());
  EXPECT_NEAR(repertoire.behavior_duration_s, 3.9, 1e-9);
  EXPECT_EQ(repertoire.options.at("population_size"), "10");
  ASSERT_FALSE(repertoire.history.empty());
  EXPECT_EQ(repertoire.history.back().evaluations, 55);
  ASSERT_FALSE(repertoire.entries.empty());
  for (const Entry& entry : repertoire.entries) {
    ASSERT_TRUE(entry.execution);
    EXPECT_EQ(entry.execution->trials, 2);
  }
}

TEST_F(LearningSessionTest, DependsOnItsSeedAndNotOnItsThreads) {
  LearnOptions one = smallRun("one.db");
  one.threads = 1;
  LearnOptions three = smallRun("three.db");
  three.threads = 3;
  LearnOptions other = smallRun("other.db");
  other.seed = 2;
  ASSERT_TRUE(learn(one) && learn(three) && learn(other));
  const Repertoire first = loadRepertoire(one.repertoire_file);
  expectSameEntries(first, loadRepertoire(three.repertoire_file));
  EXPECT_NE(digestOf(first.entries), digestOf(loadRepertoire(other.repertoire_file).entries));
}

TEST_F(LearningSessionTest, StopsWithinTheGenerationAndKeepsWholeOnes) {
  const LearnOptions options = smallRun("stopped.db");
  LearningSession session(robot_, options, [this] { return now(); });
  LearningSession::Hooks hooks;
  hooks.progress = [&](const LearningSession& running) {
    if (running.status().counters.generations == 2) session.requestStop();
  };
  EXPECT_FALSE(session.run(hooks));
  EXPECT_EQ(loadRepertoire(options.repertoire_file).generation, 2);
}

TEST_F(LearningSessionTest, ReplacesARepertoireOnlyWhenTold) {
  LearnOptions options = smallRun("kept.db");
  options.evaluations = 10;
  ASSERT_TRUE(learn(options));
  const std::string before = digestOf(loadRepertoire(options.repertoire_file).entries);
  options.seed = 2;
  EXPECT_THROW(learn(options), std::runtime_error);
  EXPECT_EQ(digestOf(loadRepertoire(options.repertoire_file).entries), before);
  options.overwrite = true;
  ASSERT_TRUE(learn(options));
  EXPECT_NE(digestOf(loadRepertoire(options.repertoire_file).entries), before);
}

TEST_F(LearningSessionTest, AsksForAFile) {
  EXPECT_THROW(learn(LearnOptions()), std::invalid_argument);
}

TEST_F(LearningSessionTest, GoesOnWhenTheFileCannotBeWrittenAndTellsSo) {
  LearnOptions options = smallRun("gone/a.db");
  options.checkpoint_period_s = 0.0;
  LearningSession session(robot_, options, [this] { return now(); });
  int failures = 0;
  LearningSession::Hooks hooks;
  hooks.save_failed = [&](const std::string& problem) {
    EXPECT_NE(problem.find("gone"), std::string::npos) << problem;
    ++failures;
  };
  hooks.progress = [&](const LearningSession& running) {
    if (running.status().counters.generations == 1) {
      fs::remove_all(folder_ / "gone");
      fs::create_directories(folder_);
      // A file where the folder was: it cannot be created anew.
      fs::create_symlink("/nowhere", folder_ / "gone");
    }
  };
  EXPECT_TRUE(session.run(hooks));
  EXPECT_GT(failures, 0);
}

TEST(LearnOptions, NamesAreUnique) {
  LearnOptions options;
  std::map<std::string, int> names;
  for (const Option& option : declareOptions(options)) EXPECT_EQ(++names[option.name], 1) << option.name;
}

}  // namespace
}  // namespace hexapod
