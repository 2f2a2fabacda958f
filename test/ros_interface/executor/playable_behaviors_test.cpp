#include "ros_interface/executor/playable_behaviors.h"

#include <gtest/gtest.h>

#include "execution/shipped_robot.h"
#include "ros_interface/executor/executor_node_options.h"

namespace hexapod {
namespace {

class PlayableBehaviorsTest : public testing::Test {
 protected:
  PlayableBehaviorsTest() {
    repertoire_.run_id = "run";
    repertoire_.robot_id = shippedRobot().digest;
    repertoire_.behavior_duration_s = 3.9;
    repertoire_.joint_names = shippedRobot().jointNames();
    repertoire_.entries.resize(1);
    repertoire_.entries[0].id = 7;
    repertoire_.entries[0].genome.assign(shippedRobot().geneCount(), 2);
  }

  hexapod_repertoire::ExecuteBehaviorGoal goal(std::int64_t entry_id, const std::string& run_id) {
    hexapod_repertoire::ExecuteBehaviorGoal goal;
    goal.entry_id = entry_id;
    goal.run_id = run_id;
    return goal;
  }

  std::string problemOf(const hexapod_repertoire::ExecuteBehaviorGoal& goal) {
    std::string problem;
    const bool found = behaviors_.find(goal, problem) != nullptr;
    EXPECT_EQ(found, problem.empty());
    return problem;
  }

  hexapod_repertoire::Repertoire repertoire_;
  PlayableBehaviors behaviors_{shippedRobot(), BehaviorOptions()};
};

TEST_F(PlayableBehaviorsTest, PlaysTheBehaviorTheLearnerEvaluated) {
  ASSERT_EQ(behaviors_.update(repertoire_), "");
  std::string problem;
  const auto behavior = behaviors_.find(goal(7, "run"), problem);
  ASSERT_TRUE(behavior) << problem;
  const Behavior learned(shippedRobot(), Genome(shippedRobot().geneCount(), 2), BehaviorOptions());
  ASSERT_EQ(behavior->commandCount(), learned.commandCount());
  for (std::size_t k = 0; k < learned.commandCount(); ++k) {
    EXPECT_EQ(behavior->command(k), learned.command(k));
  }
}

TEST_F(PlayableBehaviorsTest, PlaysGenomesInTheLevelsOfTheRepertoire) {
  repertoire_.option_names = {"gene_levels"};
  repertoire_.option_values = {"253"};
  const Genome continuous(shippedRobot().geneCount(), 100);
  repertoire_.entries[0].genome.assign(continuous.begin(), continuous.end());
  ASSERT_EQ(behaviors_.update(repertoire_), "");
  BehaviorOptions options;
  options.gene_levels = 253;
  const Behavior learned(shippedRobot(), continuous, options);
  std::string problem;
  const auto behavior = behaviors_.find(goal(7, "run"), problem);
  ASSERT_TRUE(behavior) << problem;
  EXPECT_EQ(behavior->command(50), learned.command(50));
  auto bare = goal(-1, "");
  bare.genome = repertoire_.entries[0].genome;
  EXPECT_EQ(behaviors_.find(bare, problem)->command(50), learned.command(50));
}

TEST_F(PlayableBehaviorsTest, ABareGenomeMayHaveItsOwnLevels) {
  repertoire_.option_names = {"gene_levels"};
  repertoire_.option_values = {"253"};
  ASSERT_EQ(behaviors_.update(repertoire_), "");
  auto bare = goal(-1, "");
  bare.genome.assign(shippedRobot().geneCount(), 2);
  bare.gene_levels = 5;
  std::string problem;
  const Behavior five(shippedRobot(), Genome(shippedRobot().geneCount(), 2), BehaviorOptions());
  EXPECT_EQ(behaviors_.find(bare, problem)->command(50), five.command(50));
  bare.genome[3] = 5;
  EXPECT_NE(problemOf(bare).find("Gene 3 of the genome is 5; expected 0 .. 4"), std::string::npos);
  bare.gene_levels = 7;
  EXPECT_NE(problemOf(bare).find("gene_levels is 7"), std::string::npos);
}

TEST_F(PlayableBehaviorsTest, ARepertoireThatDoesNotSayHasTheFiveLevels) {
  hexapod_repertoire::Repertoire other = repertoire_;
  other.option_names = {"gene_levels"};
  other.option_values = {"253"};
  ASSERT_EQ(behaviors_.update(other), "");
  ASSERT_EQ(behaviors_.update(repertoire_), "");
  EXPECT_EQ(behaviors_.options().gene_levels, 5);
  repertoire_.entries[0].genome[0] = 5;
  EXPECT_NE(behaviors_.update(repertoire_).find("expected 0 .. 4"), std::string::npos);
}

TEST_F(PlayableBehaviorsTest, RefusesEntriesOfOtherRunsAndUnknownOnes) {
  EXPECT_NE(problemOf(goal(7, "run")).find("No repertoire has come"), std::string::npos);
  ASSERT_EQ(behaviors_.update(repertoire_), "");
  EXPECT_EQ(problemOf(goal(7, "run")), "");
  EXPECT_NE(problemOf(goal(7, "other")).find("'other'"), std::string::npos);
  EXPECT_NE(problemOf(goal(8, "run")).find("Entry 8"), std::string::npos);
}

TEST_F(PlayableBehaviorsTest, KeepsTheEarlierOneWhenAMessageIsWrong) {
  ASSERT_EQ(behaviors_.update(repertoire_), "");
  hexapod_repertoire::Repertoire other_robots = repertoire_;
  other_robots.robot_id = "0123";
  EXPECT_NE(behaviors_.update(other_robots).find("0123"), std::string::npos);
  hexapod_repertoire::Repertoire cut = repertoire_;
  cut.entries.push_back(cut.entries[0]);
  cut.entries[1].id = 8;
  cut.entries[1].genome.pop_back();
  EXPECT_NE(behaviors_.update(cut).find("Entry 8"), std::string::npos);
  EXPECT_EQ(problemOf(goal(7, "run")), "");
  EXPECT_EQ(behaviors_.entryCount(), 1u);
}

TEST_F(PlayableBehaviorsTest, SaysWhyThereIsNothingToPlayFrom) {
  repertoire_.robot_id = "0123";
  EXPECT_NE(behaviors_.update(repertoire_).find("0123"), std::string::npos);
  EXPECT_NE(problemOf(goal(7, "run")).find("0123"), std::string::npos);
}

class TimesOfARepertoire : public PlayableBehaviorsTest {
 protected:
  void learnedWith(const std::string& name, const std::string& value) {
    repertoire_.option_names.push_back(name);
    repertoire_.option_values.push_back(value);
  }

  std::size_t commandsOf(const hexapod_repertoire::ExecuteBehaviorGoal& goal) {
    std::string problem;
    const auto behavior = behaviors_.find(goal, problem);
    EXPECT_EQ(problem, "");
    return behavior ? behavior->commandCount() : 0;
  }

  hexapod_repertoire::ExecuteBehaviorGoal bareGoal() {
    hexapod_repertoire::ExecuteBehaviorGoal bare;
    bare.entry_id = -1;
    bare.genome.assign(shippedRobot().geneCount(), 1);
    return bare;
  }
};

TEST_F(TimesOfARepertoire, AreThoseThatItsEntriesAndBareGenomesArePlayedWith) {
  EXPECT_EQ(commandsOf(bareGoal()), 130u);  // (3 + 0.6 + 0.3) s / 30 ms
  learnedWith("gait_duration_s", "1.5");
  learnedWith("return_duration_s", "0.9");
  learnedWith("rest_duration_s", "0.6");
  learnedWith("seed", "1");
  repertoire_.behavior_duration_s = 3.0;
  ASSERT_EQ(behaviors_.update(repertoire_), "");
  EXPECT_EQ(commandsOf(goal(7, "run")), 100u);
  EXPECT_EQ(commandsOf(bareGoal()), 100u);
}

TEST_F(TimesOfARepertoire, OfThePaperEndAfterTheGait) {
  learnedWith("end_pose", "after_gait");
  repertoire_.behavior_duration_s = 3.0;
  ASSERT_EQ(behaviors_.update(repertoire_), "");
  EXPECT_EQ(commandsOf(goal(7, "run")), 100u);
}

TEST_F(TimesOfARepertoire, AreRefusedWhereTheyContradictEachOther) {
  learnedWith("gait_duration_s", "1.5");
  const std::string said = behaviors_.update(repertoire_);
  EXPECT_NE(said.find("take 3.9 s"), std::string::npos) << said;
  EXPECT_NE(said.find("2.4 s"), std::string::npos) << said;
}

TEST_F(TimesOfARepertoire, AreRefusedWithAnotherCommandPeriod) {
  learnedWith("command_period_s", "0.02");
  const std::string said = behaviors_.update(repertoire_);
  EXPECT_NE(said.find("every 0.02 s"), std::string::npos) << said;
  EXPECT_NE(said.find("command_period_s"), std::string::npos) << said;
}

TEST_F(TimesOfARepertoire, AreRefusedWhereAJointCannotBeBackInTime) {
  learnedWith("return_duration_s", "0.03");
  repertoire_.behavior_duration_s = 3.33;
  const std::string said = behaviors_.update(repertoire_);
  EXPECT_NE(said.find("return_duration_s is 0.03"), std::string::npos) << said;
}

TEST_F(PlayableBehaviorsTest, MovesNoOtherJointsThanTheGoalNames) {
  hexapod_repertoire::ExecuteBehaviorGoal alone;
  alone.entry_id = -1;
  alone.genome.assign(shippedRobot().geneCount(), 4);
  alone.joints = {"leg_2_1_2"};
  std::string problem;
  const auto behavior = behaviors_.find(alone, problem);
  ASSERT_TRUE(behavior) << problem;
  const std::vector<double> neutral = shippedRobot().neutralPose();
  std::vector<bool> moved(neutral.size());
  for (std::size_t k = 0; k < behavior->commandCount(); ++k) {
    for (std::size_t j = 0; j < neutral.size(); ++j) {
      if (behavior->command(k)[j] != neutral[j]) moved[j] = true;
    }
  }
  for (std::size_t j = 0; j < neutral.size(); ++j) EXPECT_EQ(moved[j], j == 7) << j;
  alone.joints = {"leg_2_1_2", "leg_9_1_2"};
  EXPECT_NE(problemOf(alone).find("Of the 2 joints"), std::string::npos);
  ASSERT_EQ(behaviors_.update(repertoire_), "");
  hexapod_repertoire::ExecuteBehaviorGoal entry = goal(7, "run");
  entry.joints = {"leg_2_1_2"};
  EXPECT_NE(problemOf(entry).find("bare genomes only"), std::string::npos);
}

TEST(ExecutorNodeOptions, TheVelocityLimitIsNoOptionOfTheExecutor) {
  ExecutorNodeOptions options;
  EXPECT_TRUE(options.behavior.limit_velocity);
  for (const Option& option : declareOptions(options)) EXPECT_NE(option.name, "limit_velocity");
}

}  // namespace
}  // namespace hexapod
