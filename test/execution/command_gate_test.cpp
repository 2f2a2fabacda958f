#include "execution/command_gate.h"

#include <gtest/gtest.h>

#include <limits>

#include "gait/behavior.h"
#include "shipped_robot.h"

namespace hexapod {
namespace {

constexpr double kPeriod_s = 0.030;

using Passage = CommandGate::Passage;

TEST(CommandGate, PassesEveryBehaviorBitForBit) {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const Behavior behavior(shippedRobot(), randomGenome(random), BehaviorOptions());
    CommandGate gate(shippedRobot(), kPeriod_s, true);
    for (std::size_t k = 0; k < behavior.commandCount(); ++k) {
      EXPECT_EQ(gate.pass(behavior.command(k)), Passage::kUnchanged);
      EXPECT_EQ(gate.last(), behavior.command(k));
    }
  }
}

TEST(CommandGate, HoldsAJointAtItsPositionLimit) {
  CommandGate gate(shippedRobot(), kPeriod_s, false);
  std::vector<double> requested = shippedRobot().neutralPose();
  requested[4] = 9.0;
  EXPECT_EQ(gate.pass(requested), Passage::kClamped);
  EXPECT_DOUBLE_EQ(gate.last()[4], shippedRobot().joints()[4]->upper_rad);
  EXPECT_DOUBLE_EQ(gate.last()[3], requested[3]);
  EXPECT_EQ(gate.clampedCount(), 1u);
}

TEST(CommandGate, LimitsTheStepFromOneSentCommandToTheNext) {
  CommandGate gate(shippedRobot(), kPeriod_s, true);
  std::vector<double> requested = shippedRobot().neutralPose();
  requested[0] = 1.0;
  // 6.28 rad/s for 0.030 s: 0.1884 rad at a time.
  for (const double expected : {0.1884, 0.3768, 0.5652, 0.7536, 0.942}) {
    EXPECT_EQ(gate.pass(requested), Passage::kClamped);
    EXPECT_NEAR(gate.last()[0], expected, 1e-8);
  }
  EXPECT_EQ(gate.pass(requested), Passage::kUnchanged);
}

TEST(CommandGate, RefusesWhatIsNotFiniteOrOfTheWrongLength) {
  CommandGate gate(shippedRobot(), kPeriod_s, true);
  const std::vector<double> neutral = shippedRobot().neutralPose();
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    std::vector<double> requested = neutral;
    requested[17] = bad;
    EXPECT_EQ(gate.pass(requested), Passage::kRefused);
    EXPECT_EQ(gate.last(), neutral);
  }
  EXPECT_EQ(gate.pass({}), Passage::kRefused);
  EXPECT_EQ(gate.pass(std::vector<double>(19, 0.0)), Passage::kRefused);
}

TEST(CommandGate, StartsFromAMeasuredPoseWithinTheLimits) {
  CommandGate gate(shippedRobot(), kPeriod_s, true);
  std::vector<double> measured = shippedRobot().neutralPose();
  measured[2] = -1.6;
  measured[3] = 0.5;
  gate.reset(measured);
  EXPECT_DOUBLE_EQ(gate.last()[2], shippedRobot().joints()[2]->lower_rad);
  EXPECT_DOUBLE_EQ(gate.last()[3], 0.5);
}

}  // namespace
}  // namespace hexapod
