#include "evaluation/behavior_evaluator.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "simulation/rollout.h"
#include "simulation/test_robots.h"

namespace hexapod {
namespace {

std::shared_ptr<WorldPool> pool(const RobotDescription& robot, int threads) {
  return std::make_shared<WorldPool>(Engine::kOde, robot, Physics(), threads);
}

void expectEqual(const std::vector<Outcome>& found, const std::vector<Outcome>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].verdict, expected[i].verdict) << i;
    EXPECT_EQ(found[i].end_pose.x_m, expected[i].end_pose.x_m) << i;
    EXPECT_EQ(found[i].end_pose.y_m, expected[i].end_pose.y_m) << i;
    EXPECT_EQ(found[i].end_pose.yaw_rad, expected[i].end_pose.yaw_rad) << i;
    EXPECT_EQ(found[i].cost, expected[i].cost) << i;
  }
}

TEST(BehaviorEvaluator, GivesTheSameOnTwoAndEightThreadsAsOneByOne) {
  const RobotDescription robot = handMadeHexapod();
  const std::vector<Genome> genomes = randomGenomes(robot, 10, 7);
  const std::unique_ptr<World> world = makeWorld(Engine::kOde, robot, Physics());
  std::vector<Outcome> one_by_one;
  for (const Genome& genome : genomes) {
    world->restart();
    one_by_one.push_back(play(*world, Behavior(robot, genome, shortBehavior()), 0.030));
  }
  for (const int threads : {2, 8}) {
    SCOPED_TRACE(threads);
    BehaviorEvaluator evaluator(pool(robot, threads), shortBehavior());
    expectEqual(evaluator.evaluate(genomes), one_by_one);
  }
}

TEST(BehaviorEvaluator, GivesEqualGaitsEqualOutcomes) {
  const RobotDescription robot = handMadeHexapod();
  Genome genome = tripod(robot);
  Genome equal = genome;
  for (std::size_t g = 1; g < equal.size(); g += 2) {
    if (equal[g] == 0) equal[g] = 4;
  }
  ASSERT_NE(genome, equal);
  BehaviorEvaluator evaluator(pool(robot, 1), shortBehavior());
  const std::vector<Outcome> outcomes = evaluator.evaluate({genome, equal});
  expectEqual({outcomes[1]}, {outcomes[0]});
}

TEST(BehaviorEvaluator, CountsSimulationsAndFailures) {
  const RobotDescription robot = hexapodWithWideHips();
  BehaviorEvaluator evaluator(pool(robot, 1), shortBehavior());
  EXPECT_TRUE(evaluator.evaluate({}).empty());
  evaluator.evaluate({standing(robot), tripod(robot)});
  evaluator.evaluate({standing(robot)});
  EXPECT_EQ(evaluator.counts().simulations, 3);
  EXPECT_EQ(evaluator.counts().self_collided, 1);
  EXPECT_EQ(evaluator.counts().failures(), 1);
}

TEST(BehaviorEvaluator, NamesTheGenomeThatCannotBeSimulated) {
  const RobotDescription robot = handMadeHexapod();
  BehaviorEvaluator evaluator(pool(robot, 2), shortBehavior());
  try {
    evaluator.evaluate({standing(robot), {1, 2, 3, 0}});
    FAIL() << "simulated a genome of four genes";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("Genome 1230 cannot be simulated"), std::string::npos)
        << error.what();
  }
  EXPECT_TRUE(evaluator.evaluate({standing(robot)})[0].walked());
}

TEST(BehaviorEvaluator, SaysWhyNoWorldCanBeBuilt) {
  RobotDescription weak = handMadeHexapod();
  for (Leg& leg : weak.legs) {
    for (Segment& segment : leg.segments) segment.joint.max_torque_nm = 0.0;
  }
  BehaviorEvaluator evaluator(pool(weak, 2), shortBehavior());
  EXPECT_THROW(evaluator.evaluate({standing(weak)}), std::runtime_error);
}

TEST(WorldPool, RefusesANegativeNumberOfThreads) {
  EXPECT_THROW(WorldPool(Engine::kOde, handMadeHexapod(), Physics(), -1), std::invalid_argument);
}

}  // namespace
}  // namespace hexapod
