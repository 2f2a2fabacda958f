#include "transferability/simulated_trial_robot.h"

#include <gtest/gtest.h>

#include "gait/behavior.h"
#include "robot/load_robot.h"
#include "simulation/body_text.h"
#include "simulation/rollout.h"

namespace hexapod {
namespace {

const Genome kWalk = genomeFromString("411044104110441041104410");

TEST(SimulatedTrialRobot, DoesWhatOdeDoesWithThatBodyWhateverItPlayedBefore) {
  const RobotDescription robot = loadRobot("urdf/hexapod.urdf", "config/hexapod.yaml");
  const BehaviorOptions behavior;
  const Physics body = bodyFromText(robot, "friction: 0.6, gain: 0.7");
  SimulatedTrialRobot tried(robot, body, behavior);
  const auto first = tried.play(kWalk);
  const auto second = tried.play(kWalk);
  const Outcome alone = play(*makeWorld(Engine::kOde, robot, body),
                             Behavior(robot, kWalk, behavior), behavior.command_period_s);
  ASSERT_TRUE(alone.walked());
  for (const auto& result : {first, second}) {
    EXPECT_TRUE(result.was_played);
    ASSERT_TRUE(result.start_from_end);
    EXPECT_EQ(result.start_from_end->x_m, alone.end_pose.x_m);
    EXPECT_EQ(result.start_from_end->yaw_rad, alone.end_pose.yaw_rad);
  }
}

TEST(SimulatedTrialRobot, TellsOfAFall) {
  const RobotDescription robot = loadRobot("urdf/hexapod.urdf", "config/hexapod.yaml");
  // So little torque does not hold it up.
  SimulatedTrialRobot tried(robot, bodyFromText(robot, "torque: 0.12"), {});
  const TrialRobot::Result result = tried.play(kWalk);
  EXPECT_TRUE(result.was_played);
  EXPECT_FALSE(result.start_from_end);
}

}  // namespace
}  // namespace hexapod
