#include "simulation/rollout.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "robot/load_robot.h"
#include "test_robots.h"

namespace hexapod {
namespace {

Outcome playOnce(const RobotDescription& robot, const Genome& genome, const Physics& physics) {
  const BehaviorOptions options;
  const std::unique_ptr<World> world = makeWorld(Engine::kOde, robot, physics);
  return play(*world, Behavior(robot, genome, options), options.command_period_s);
}

TEST(Play, AGaitWithoutAmplitudeStaysWhereItIs) {
  const RobotDescription robot = handMadeHexapod();
  const Outcome outcome = playOnce(robot, standing(robot), Physics());
  ASSERT_TRUE(outcome.walked());
  EXPECT_LT(std::hypot(outcome.end_pose.x_m, outcome.end_pose.y_m), 1e-3);
  EXPECT_LT(std::abs(outcome.end_pose.yaw_rad), 1e-3);
}

TEST(Play, ATripodWalksForwardFromWhereverItStarts) {
  const RobotDescription robot = handMadeHexapod();
  const BehaviorOptions options;
  const Behavior walk(robot, tripod(robot), options);
  const std::unique_ptr<World> world = makeWorld(Engine::kOde, robot, Physics());
  const Outcome first = play(*world, walk, options.command_period_s);
  ASSERT_TRUE(first.walked());
  EXPECT_GT(first.end_pose.x_m, 0.2);
  EXPECT_LT(std::abs(first.end_pose.y_m), 0.1);

  const Pose2 middle = footprint(world->worldFromBase());
  const Outcome second = play(*world, walk, options.command_period_s);
  ASSERT_TRUE(second.walked());
  EXPECT_NEAR(second.end_pose.x_m, first.end_pose.x_m, 0.1);
  const Pose2 expected = middle * second.end_pose;
  EXPECT_LT(distance(footprint(world->worldFromBase()), expected), 2e-5);
}

TEST(Play, TheShippedRobotStandsAndWalks) {
  const RobotDescription robot = loadRobot("urdf/hexapod.urdf", "config/hexapod.yaml");
  const BehaviorOptions options;
  const std::unique_ptr<World> world = makeWorld(Engine::kOde, robot, Physics());
  const Outcome stood = play(*world, Behavior(robot, standing(robot), options), 0.030);
  ASSERT_TRUE(stood.walked());
  EXPECT_LT(distance(stood.end_pose, Pose2()), 1e-3);
  world->restart();
  const Outcome walked = play(*world, Behavior(robot, tripod(robot), options), 0.030);
  ASSERT_TRUE(walked.walked());
  EXPECT_GT(walked.end_pose.x_m, 0.2);
}

TEST(Play, WalksLessFarUphill) {
  const RobotDescription robot = handMadeHexapod();
  Physics uphill;
  uphill.slope_x_rad = 0.05;
  Physics downhill;
  downhill.slope_x_rad = -0.05;
  const Outcome up = playOnce(robot, tripod(robot), uphill);
  const Outcome down = playOnce(robot, tripod(robot), downhill);
  ASSERT_TRUE(up.walked());
  ASSERT_TRUE(down.walked());
  EXPECT_LT(up.end_pose.x_m + 0.02, down.end_pose.x_m);
}

TEST(Play, NamesTheFailureAndStopsThere) {
  const RobotDescription robot = hexapodWithWideHips();
  const Outcome collided = playOnce(robot, tripod(robot), Physics());
  EXPECT_EQ(collided.verdict, Verdict::kSelfCollided);

  RobotDescription low = handMadeHexapod();
  low.failure.max_base_height_m = 0.146;
  EXPECT_EQ(playOnce(low, tripod(low), Physics()).verdict, Verdict::kFell);
}

TEST(Play, RefusesACommandPeriodThatIsNoMultipleOfTheStep) {
  const RobotDescription robot = handMadeHexapod();
  Physics physics;
  physics.step_s = 0.02;
  try {
    playOnce(robot, standing(robot), physics);
    FAIL() << "played 30 ms commands at a 20 ms step";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("0.03 s is not a multiple"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace hexapod
