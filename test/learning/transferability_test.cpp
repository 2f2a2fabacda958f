#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "learning_fixture.h"
#include "repertoire/repertoire_rows.h"
#include "transferability/trial_robot.h"

namespace hexapod {
namespace {

/// A robot that takes two thirds of every step, when it plays at all.
class ShortRobot : public TrialRobot {
 public:
  explicit ShortRobot(const std::vector<int>& refused = {}) : refused_(refused) {}

  Result play(const Genome& genome) override {
    genomes.push_back(genome);
    const auto asked = static_cast<int>(genomes.size());
    if (std::count(refused_.begin(), refused_.end(), asked) > 0) {
      return {false, std::nullopt, "The executor is disarmed."};
    }
    return {true, Pose2{0.02 * static_cast<double>(genome[0]), 0.01, 0.0}, ""};
  }

  std::vector<Genome> genomes;

 private:
  std::vector<int> refused_;
};

class TransferabilityTest : public LearningFixture {
 protected:
  /// Two trials after each generation, seven in all.
  LearnOptions transferRun(const std::string& name) const {
    LearnOptions options = smallRun(name);
    options.transfer.transferability = true;
    options.transfer.trials = 7;
    options.transfer.trials_at_once = 2;
    options.transfer.trial_period = 1;
    return options;
  }

  LearnOptions simulatedRun(const std::string& name) const {
    LearnOptions options = transferRun(name);
    options.transfer.robot_body = "friction: 0.6, gain: 0.7";
    return options;
  }

  bool learnWith(TrialRobot& robot, const LearnOptions& options,
                 const LearningSession::Hooks& hooks = {}) {
    return LearningSession(
               robot_, options, [this] { return now(); }, {}, &robot)
        .run(hooks);
  }
};

TEST_F(TransferabilityTest, KeepsEveryTrialInTheFile) {
  const LearnOptions options = transferRun("a.db");
  ShortRobot robot;
  ASSERT_TRUE(learnWith(robot, options));
  const std::vector<RobotTrial> trials = loadRepertoire(options.repertoire_file).trials;
  ASSERT_EQ(trials.size(), 7u);
  ASSERT_EQ(robot.genomes.size(), 7u);
  for (std::size_t i = 0; i < trials.size(); ++i) {
    EXPECT_EQ(trials[i].genome, robot.genomes[i]);
    EXPECT_EQ(trials[i].measured->y_m, 0.01);
    EXPECT_EQ(trials[i].evaluation, 10 * static_cast<std::int64_t>(1 + i / 2));
  }
}

TEST_F(TransferabilityTest, ExpectsEntriesWhereTheRobotWouldTakeThem) {
  LearnOptions options = simulatedRun("a.db");
  ASSERT_TRUE(learn(options));
  const Repertoire there = loadRepertoire(options.repertoire_file);
  // What validation said of them is what it says of the same entries by themselves.
  for (const Entry& entry : there.entries) {
    ASSERT_TRUE(entry.execution);
    EXPECT_GT(entry.execution->spread_m, 0.001);
    EXPECT_NE(entry.execution->mean.x_m, entry.end_pose.x_m);
  }
}

TEST_F(TransferabilityTest, GoesOnWithoutATrialThatFailedAndSaysSo) {
  const LearnOptions options = transferRun("a.db");
  ShortRobot robot({2, 3});
  std::vector<std::string> problems;
  LearningSession::Hooks hooks;
  hooks.trial_failed = [&](const std::string& problem) { problems.push_back(problem); };
  ASSERT_TRUE(learnWith(robot, options, hooks));
  // The second of the first series and the first of the second, which ends with it.
  EXPECT_EQ(problems, std::vector<std::string>(2, "The executor is disarmed."));
  const Repertoire repertoire = loadRepertoire(options.repertoire_file);
  EXPECT_EQ(repertoire.evaluations, 55);
  EXPECT_EQ(repertoire.trials.size(), 7u);
  EXPECT_EQ(robot.genomes.size(), 9u);
}

TEST_F(TransferabilityTest, EndsTheSameWhereverItIsKilled) {
  const LearnOptions options = simulatedRun("a.db");
  LearnOptions resumed = options;
  resumed.resume = true;
  for (int round = 0; round < 8; ++round) {
    LearningSession::Hooks hooks;  // after the next trial, or the next generation
    hooks.tried = [&](const std::string&) {
      if (round % 2 == 0) throw Killed();
    };
    hooks.progress = [&](const LearningSession& session) {
      if (session.status().phase == LearningPhase::kEvolving) throw Killed();
    };
    try {
      learn(resumed, hooks);
    } catch (const Killed&) {
    }
  }
  ASSERT_TRUE(learn(resumed));
  const Repertoire killed = loadRepertoire(options.repertoire_file);
  const Repertoire whole = undisturbed(options);
  expectSameRun(killed, whole);
  EXPECT_EQ(killed.trials.size(), 7u);
  EXPECT_EQ(digestOf(killed.trials), digestOf(whole.trials));
}

TEST_F(TransferabilityTest, IsTheSameForAnyNumberOfThreads) {
  LearnOptions options = simulatedRun("a.db");
  options.threads = 1;
  const Repertoire one = undisturbed(options);
  options.threads = 3;
  const Repertoire three = undisturbed(options);
  expectSameRun(one, three);
  EXPECT_EQ(digestOf(one.trials), digestOf(three.trials));
}

TEST_F(TransferabilityTest, NeedsARobotAndLeavesNothingWithoutOne) {
  const LearnOptions options = transferRun("a.db");
  const std::string sentence = complaintOf([&] { learn(options); });
  EXPECT_TRUE(mentions(sentence, "robot_body")) << sentence;
  EXPECT_FALSE(std::filesystem::exists(options.repertoire_file));
}

TEST_F(TransferabilityTest, ThatIsOffIsNoPartOfTheRun) {
  LearnOptions options = smallRun("a.db");
  options.transfer.trials = 5;
  EXPECT_EQ(undisturbed(options).run_id, undisturbed(smallRun("b.db")).run_id);
  EXPECT_NE(undisturbed(simulatedRun("c.db")).run_id, undisturbed(options).run_id);
}

}  // namespace
}  // namespace hexapod
