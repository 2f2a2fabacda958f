#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <string>

#include "learning/learning_session.h"
#include "repertoire/repertoire_file.h"
#include "robot/load_robot.h"

namespace hexapod {

/// Ends a session as a kill does: at once, without another save.
struct Killed : std::exception {};

/// Small runs in a folder of the test's own, under a clock that advances by half a second whenever
/// it is looked at.
class LearningFixture : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) /
              (std::string("hexapod_") + test->test_suite_name() + "_" + test->name());
    std::filesystem::remove_all(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// Five generations and a half, saved after each; without the verification, which takes ODE.
  LearnOptions smallRun(const std::string& name) const {
    LearnOptions options;
    options.repertoire_file = (folder_ / name).string();
    options.evolution.population_size = 10;
    options.evaluations = 55;
    options.validation_trials = 2;
    options.verify_with_ode = false;
    options.resimulate = false;
    options.checkpoint_period_s = 0.0;
    return options;
  }

  double now() { return time_s_ += 0.5; }

  bool learn(const LearnOptions& options, const LearningSession::Hooks& hooks = {}) {
    return LearningSession(robot_, options, [this] { return now(); }).run(hooks);
  }

  /// Learns from the start to the end, in a file of its own.
  Repertoire undisturbed(LearnOptions options) {
    options.repertoire_file = (folder_ / "undisturbed.db").string();
    options.overwrite = true;
    options.resume = false;
    EXPECT_TRUE(learn(options));
    return loadRepertoire(options.repertoire_file);
  }

  /// Learns until `when` holds, and is killed then.
  void killWhen(const LearnOptions& options,
                const std::function<bool(const LearningStatus&)>& when) {
    LearningSession::Hooks hooks;
    hooks.progress = [&](const LearningSession& session) {
      if (when(session.status())) throw Killed();
    };
    EXPECT_THROW(learn(options, hooks), Killed);
  }

  void killAfterGeneration(const LearnOptions& options, std::int64_t generation) {
    killWhen(options, [generation](const LearningStatus& status) {
      return status.counters.generations == generation;
    });
  }

  /// Learns to the end, killed after every generation of a small run and resumed.
  Repertoire killedAgainAndAgain(LearnOptions options) {
    options.resume = true;
    for (std::int64_t generation = 1; generation <= 5; ++generation) {
      killAfterGeneration(options, generation);
    }
    EXPECT_TRUE(learn(options));
    return loadRepertoire(options.repertoire_file);
  }

  const RobotDescription robot_ = loadRobot("urdf/hexapod.urdf", "config/hexapod.yaml");
  std::filesystem::path folder_;
  double time_s_ = 0.0;
};

/// Same entries with the same executions, same name, same history but for the clock.
inline void expectSameRun(const Repertoire& a, const Repertoire& b) {
  ASSERT_EQ(a.entries.size(), b.entries.size());
  EXPECT_EQ(digestOf(a.entries), digestOf(b.entries));
  EXPECT_EQ(a.run_id, b.run_id);
  EXPECT_EQ(a.evaluations, b.evaluations);
  EXPECT_EQ(a.generation, b.generation);
  ASSERT_EQ(a.history.size(), b.history.size());
  for (std::size_t i = 0; i < a.history.size(); ++i) {
    EXPECT_EQ(a.history[i].evaluations, b.history[i].evaluations);
    EXPECT_EQ(a.history[i].archive_size, b.history[i].archive_size);
    EXPECT_EQ(a.history[i].sparseness_m, b.history[i].sparseness_m);
  }
}

/// What `call` complains, or "" when it does not.
template <typename Call>
std::string complaintOf(const Call& call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

inline bool mentions(const std::string& sentence, const std::string& words) {
  return sentence.find(words) != std::string::npos;
}

}  // namespace hexapod
