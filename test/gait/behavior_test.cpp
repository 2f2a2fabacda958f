#include "gait/behavior.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gait/gait.h"
#include "gait/random_genome.h"
#include "made_robot.h"
#include "robot/load_robot.h"

namespace hexapod {
namespace {

RobotDescription shipped() { return loadRobot("urdf/hexapod.urdf", "config/hexapod.yaml"); }

// The paper's reading: eq. 3 as it is, nothing after it.
BehaviorOptions asInThePaper() {
  BehaviorOptions options;
  options.end_pose = EndPose::kAfterGait;
  options.limit_velocity = false;
  return options;
}

double largestStep(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t j = 0; j < a.size(); ++j) largest = std::max(largest, std::abs(a[j] - b[j]));
  return largest;
}

TEST(Behavior, AfterGaitIsEquationThreeEveryThirtyMilliseconds) {
  const RobotDescription robot = shipped();
  Random random(4);
  const Genome genome = randomGenome(random);
  const Behavior behavior(robot, genome, asInThePaper());
  ASSERT_EQ(behavior.commandCount(), 100u);
  EXPECT_DOUBLE_EQ(behavior.duration_s(), 3.0);
  const Gait gait(robot, genome);
  std::vector<double> angles;
  for (std::size_t k = 0; k < 100; ++k) {
    gait.angles(0.03 * k, angles);
    EXPECT_LT(largestStep(behavior.command(k), angles), 1e-14) << k;
  }
}

TEST(Behavior, OfAnyGenomeHasTheSameLengthAndEndsAtRestInTheNeutralPose) {
  const RobotDescription robot = shipped();
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    const Behavior behavior(robot, randomGenome(random), BehaviorOptions());
    // 3 s of gait, 0.6 s back, 0.3 s at rest: 100 + 20 + 10 commands of 30 ms.
    ASSERT_EQ(behavior.commandCount(), 130u);
    EXPECT_DOUBLE_EQ(behavior.duration_s(), 3.9);
    for (std::size_t k = 119; k < 130; ++k) EXPECT_EQ(behavior.command(k), robot.neutralPose());
  }
}

TEST(Behavior, StaysWithinPositionAndVelocityLimits) {
  const RobotDescription robot = shipped();
  const double reach_rad = 6.28 * 0.03;
  Random random(6);
  for (int i = 0; i < 200; ++i) {
    const Behavior behavior(robot, randomGenome(random), BehaviorOptions());
    std::vector<double> previous = robot.neutralPose();
    for (std::size_t k = 0; k < behavior.commandCount(); ++k) {
      EXPECT_LE(largestStep(behavior.command(k), previous), reach_rad + 1e-12) << k;
      for (double angle : behavior.command(k)) EXPECT_LE(std::abs(angle), 1.57079632679);
      previous = behavior.command(k);
    }
  }
}

TEST(Behavior, LimitedCommandsGoTowardsTheGaitAsFastAsAllowed) {
  const RobotDescription robot = shipped();
  const Genome genome(24, 4);
  const Behavior behavior(robot, genome, BehaviorOptions());
  // Command 1 of the lifting joint: eq. 3 asks for pi/4 tanh(4 sin(2 pi 0.03)) = 0.499 rad, one
  // period at 6.28 rad/s allows 0.1884 rad.
  EXPECT_NEAR(behavior.command(1)[1], 0.1884, 1e-12);
  EXPECT_NEAR(behavior.command(2)[1], 0.3768, 1e-12);
  // At a quarter of the period it has caught up.
  std::vector<double> angles;
  Gait(robot, genome).angles(0.24, angles);
  EXPECT_NEAR(behavior.command(8)[1], angles[1], 1e-12);
}

TEST(Behavior, ReturnsOnAStraightRamp) {
  const RobotDescription robot = shipped();
  const Behavior behavior(robot, Genome(24, 2), BehaviorOptions());
  const std::vector<double>& last = behavior.command(99);
  ASSERT_GT(std::abs(last[1]), 0.05);
  for (std::size_t k = 100; k < 120; ++k) {
    const double left = 1.0 - (k - 99) / 20.0;
    EXPECT_NEAR(behavior.command(k)[1], left * last[1], 1e-14) << k;
  }
}

TEST(Behavior, WithoutRampGoesStraightToRest) {
  const RobotDescription robot = shipped();
  BehaviorOptions options;
  options.return_duration_s = 0.0;
  options.limit_velocity = false;
  const Behavior behavior(robot, Genome(24, 1), options);
  ASSERT_EQ(behavior.commandCount(), 110u);
  EXPECT_EQ(behavior.command(100), robot.neutralPose());
}

TEST(Behavior, CommandsAreClampedToThePositionLimits) {
  RobotDescription robot = madeRobot(1, 1);
  robot.legs[0].segments[0].joint.upper_rad = 0.2;
  const Behavior behavior(robot, {4, 0, 0, 0}, asInThePaper());
  for (std::size_t k = 0; k < behavior.commandCount(); ++k) {
    EXPECT_LE(behavior.command(k)[0], 0.2);
  }
  EXPECT_EQ(behavior.command(8)[0], 0.2);
}

TEST(Behavior, EqualGaitsHaveEqualCommands) {
  const RobotDescription robot = shipped();
  Genome genome(24, 2);
  genome[1] = 0;
  Genome same = genome;
  same[1] = 4;
  const Behavior a(robot, genome, BehaviorOptions());
  const Behavior b(robot, same, BehaviorOptions());
  for (std::size_t k = 0; k < a.commandCount(); ++k) EXPECT_EQ(a.command(k), b.command(k));
}

TEST(Behavior, MadeAloneOrAmongManyIsTheSame) {
  const RobotDescription robot = shipped();
  Random random(8);
  for (const std::int64_t levels : {5, 253}) {
    BehaviorOptions options;
    options.gene_levels = levels;
    const BehaviorMaker maker(robot, options);
    for (int i = 0; i < 10; ++i) {
      Genome genome(24);
      for (auto& level : genome) level = static_cast<std::uint8_t>(random.below(levels));
      const Behavior alone(robot, genome, options);
      const Behavior among = maker.make(genome);
      ASSERT_EQ(alone.commandCount(), among.commandCount());
      for (std::size_t k = 0; k < alone.commandCount(); ++k) {
        EXPECT_EQ(alone.command(k), among.command(k));
      }
    }
  }
}

TEST(Behavior, LevelsThatMakeNoGaitAreRefused) {
  BehaviorOptions options;
  for (const std::int64_t levels : {0, 4, 6, 254}) {
    options.gene_levels = levels;
    EXPECT_NE(complaintOf([&] { Behavior(shipped(), Genome(24, 0), options); }).find("gene_levels"),
              std::string::npos);
  }
}

TEST(Behavior, MovesAQuadrupedOfTwoJointsPerLeg) {
  const RobotDescription robot = madeRobot(4, 2);
  const Behavior behavior(robot, Genome(16, 3), BehaviorOptions());
  EXPECT_EQ(behavior.commandCount(), 130u);
  EXPECT_EQ(behavior.command(50).size(), 8u);
  EXPECT_EQ(behavior.command(129), robot.neutralPose());
}

TEST(Behavior, GenomeOfAnotherRobotIsRefused) {
  const RobotDescription robot = madeRobot(4, 2);
  EXPECT_NE(complaintOf([&] { Behavior(robot, Genome(24, 0), BehaviorOptions()); }), "");
}

}  // namespace
}  // namespace hexapod
