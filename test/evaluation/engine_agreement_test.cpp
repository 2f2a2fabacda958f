#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "evaluation/behavior_evaluator.h"
#include "evolution/br_evolution.h"
#include "gait/behavior.h"
#include "geometry/pose2.h"
#include "robot/load_robot.h"
#include "simulation/ode/ode_world.h"
#include "simulation/reduced/reduced_world.h"
#include "simulation/rollout.h"

// The shipped robot in both engines: where they have to agree although ODE's solver gives up, and
// what their agreement is for.

namespace hexapod {
namespace {

RobotDescription shippedRobot() { return loadRobot("urdf/hexapod.urdf", "config/hexapod.yaml"); }

// With the joints of the published simulator dSolveLCP gives up on the first steps of these; not
// repeated, the behaviours end 12 and 3 mm away.
RobotDescription robotWithTies() {
  RobotDescription robot = shippedRobot();
  robot.contact.joint_cfm = 1e-10;
  return robot;
}

TEST(EngineAgreement, HoldsWhereOdesSolverGivesUpOnATie) {
  const RobotDescription robot = robotWithTies();
  OdeWorld ode(robot, Physics());
  ReducedWorld reduced(robot, Physics());
  for (const char* digits : {"202040400020000000433000", "002022403012102200430010"}) {
    const Behavior behavior(robot, genomeFromString(digits), BehaviorOptions());
    ASSERT_TRUE(play(ode, behavior, 0.030).walked());
    ASSERT_TRUE(play(reduced, behavior, 0.030).walked());
    const Pose2 expected = footprint(ode.worldFromBase()), end = footprint(reduced.worldFromBase());
    EXPECT_LT(distance(end, expected), 1e-7) << digits;
    EXPECT_LT(headingDistance(end, expected), 1e-6) << digits;
  }
}

TEST(EngineAgreement, RepeatsAStepThatWasGivenUpTheSameWayEveryTime) {
  const RobotDescription robot = robotWithTies();
  const Behavior behavior(robot, genomeFromString("202040400020000000433000"), BehaviorOptions());
  OdeWorld world(robot, Physics());
  std::vector<std::vector<double>> ends;
  for (int run = 0; run < 2; ++run) {
    world.restart();
    play(world, behavior, 0.030);
    ends.push_back(world.state().values);
  }
  EXPECT_EQ(ends[0], ends[1]);
}

std::vector<Entry> evolved(Engine engine, const RobotDescription& robot) {
  BehaviorOptions behavior;
  behavior.gait_duration_s = 1.5;
  BehaviorEvaluator evaluator(std::make_shared<WorldPool>(engine, robot, Physics()), behavior);
  EvolutionOptions options;
  options.population_size = 20;
  options.novelty_threshold_m = 0.05;
  BrEvolution evolution(options, robot.geneCount(), Random(3));
  while (evolution.counters().evaluations < 120) advance(evolution, evaluator);
  return evolution.archive().entries();
}

TEST(EngineAgreement, GivesTheSameRepertoireFromTheSameSeed) {
  const RobotDescription robot = shippedRobot();
  const std::vector<Entry> expected = evolved(Engine::kOde, robot);
  const std::vector<Entry> entries = evolved(Engine::kReduced, robot);
  ASSERT_GT(expected.size(), 10u);
  ASSERT_EQ(entries.size(), expected.size());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    EXPECT_EQ(entries[i].id, expected[i].id);
    EXPECT_EQ(entries[i].genome, expected[i].genome);
    EXPECT_EQ(entries[i].evaluation, expected[i].evaluation);
    EXPECT_EQ(entries[i].end_pose.x_m, expected[i].end_pose.x_m);
    EXPECT_EQ(entries[i].end_pose.y_m, expected[i].end_pose.y_m);
    EXPECT_EQ(entries[i].end_pose.yaw_rad, expected[i].end_pose.yaw_rad);
    EXPECT_EQ(entries[i].cost, expected[i].cost);
  }
}

}  // namespace
}  // namespace hexapod
