#include "execution/command_gate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "gait/behavior.h"
#include "gait/random_genome.h"
#include "shipped_robot.h"

namespace hexapod {
namespace {

using Passage = CommandGate::Passage;

TEST(CommandGate, PassesEveryBehaviorBitForBit) {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const Behavior behavior(shippedRobot(), randomGenome(random), BehaviorOptions());
    CommandGate gate(shippedRobot(), kPeriod_s);
    for (std::size_t k = 0; k < behavior.commandCount(); ++k) {
      EXPECT_EQ(gate.pass(behavior.command(k)), Passage::kUnchanged);
      EXPECT_EQ(gate.last(), behavior.command(k));
    }
  }
}

TEST(CommandGate, HoldsAJointAtItsPositionLimit) {
  CommandGate gate(shippedRobot(), kPeriod_s);
  std::vector<double> requested = shippedRobot().neutralPose();
  requested[4] = 9.0;
  // pi / 2 at 0.1884 rad a step.
  for (int step = 0; step < 9; ++step) EXPECT_EQ(gate.pass(requested), Passage::kClamped);
  EXPECT_DOUBLE_EQ(gate.last()[4], shippedRobot().joints()[4]->upper_rad);
  EXPECT_DOUBLE_EQ(gate.last()[3], requested[3]);
  EXPECT_EQ(gate.clampedCount(), 9u);
}

TEST(CommandGate, LimitsTheStepFromOneSentCommandToTheNext) {
  CommandGate gate(shippedRobot(), kPeriod_s);
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
  CommandGate gate(shippedRobot(), kPeriod_s);
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
  CommandGate gate(shippedRobot(), kPeriod_s);
  std::vector<double> measured = shippedRobot().neutralPose();
  measured[2] = -1.6;
  measured[3] = 0.5;
  gate.reset(measured);
  EXPECT_DOUBLE_EQ(gate.last()[2], shippedRobot().joints()[2]->lower_rad);
  EXPECT_DOUBLE_EQ(gate.last()[3], 0.5);
}

// A gate of 50 rad/s^2: steps differ by at most 50 * 0.030^2 = 0.045 rad.
GateOptions accelerated() {
  GateOptions options;
  options.max_acceleration_rad_per_s2 = 50.0;
  return options;
}

TEST(CommandGate, WithAnAccelerationLimitSpeedsUpAndBrakesToArrive) {
  CommandGate gate(shippedRobot(), kPeriod_s, accelerated());
  std::vector<double> requested = shippedRobot().neutralPose();
  requested[0] = 0.4;
  // Steps of 1, 2, 3 times 0.045 rad, and down again; 0.4 rad are left without overshoot.
  std::vector<double> way{0.0};
  for (int i = 0; i < 12; ++i) {
    gate.pass(requested);
    way.push_back(gate.last()[0]);
  }
  EXPECT_NEAR(way[1], 0.045, 1e-9);
  EXPECT_NEAR(way[2], 0.135, 1e-9);
  EXPECT_DOUBLE_EQ(way.back(), 0.4);
  EXPECT_LE(*std::max_element(way.begin(), way.end()), 0.4 + 0.045);
}

// Random requests, jumps, rests and resets; each step checked against the definition.
TEST(CommandGate, WhateverIsAskedPositionVelocityAndAccelerationLimitsAreKept) {
  GateOptions options = accelerated();
  options.soft_limit_margin_rad = 0.2;
  CommandGate gate(shippedRobot(), kPeriod_s, options);
  Random random(8);
  const std::vector<const Joint*> joints = shippedRobot().joints();
  std::vector<double> requested = shippedRobot().neutralPose();
  std::vector<double> before = requested;
  std::vector<double> step(requested.size(), 0.0);
  for (int i = 0; i < 20000; ++i) {
    for (double& angle : requested) {
      if (random.chance(0.2)) angle = random.uniform(-9.0, 9.0);
      if (random.chance(0.2)) angle = before[0];
    }
    if (random.chance(0.01)) {
      gate.rest();
      step.assign(step.size(), 0.0);
    }
    gate.pass(requested);
    for (std::size_t j = 0; j < joints.size(); ++j) {
      const double now = gate.last()[j] - before[j];
      ASSERT_LE(std::abs(now), 6.28 * kPeriod_s * (1 + 1e-8));
      ASSERT_LE(std::abs(now - step[j]), 0.045 * (1 + 1e-8)) << i;
      ASSERT_LE(gate.last()[j], joints[j]->upper_rad - 0.2);
      ASSERT_GE(gate.last()[j], joints[j]->lower_rad + 0.2);
      step[j] = now;
    }
    before = gate.last();
  }
}

TEST(CommandGate, AJointFoundWithinTheSoftMarginMovesOutOfItOnly) {
  GateOptions options;
  options.soft_limit_margin_rad = 0.2;
  CommandGate gate(shippedRobot(), kPeriod_s, options);
  const double upper = shippedRobot().joints()[0]->upper_rad;
  std::vector<double> pose = shippedRobot().neutralPose();
  pose[0] = upper - 0.1;
  gate.reset(pose);
  pose[0] = upper;
  gate.pass(pose);
  EXPECT_DOUBLE_EQ(gate.last()[0], upper - 0.1) << "stays: no jump of the servo either";
  pose[0] = upper - 0.15;
  gate.pass(pose);
  EXPECT_DOUBLE_EQ(gate.last()[0], upper - 0.15);
  pose[0] = upper - 0.1;
  gate.pass(pose);
  EXPECT_DOUBLE_EQ(gate.last()[0], upper - 0.15);
}

TEST(CommandGate, RefusesAMarginThatForbidsTheNeutralPose) {
  GateOptions options;
  options.soft_limit_margin_rad = 2.0;
  try {
    CommandGate gate(shippedRobot(), kPeriod_s, options);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("body_leg_0"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace hexapod
