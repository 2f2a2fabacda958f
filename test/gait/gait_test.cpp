#include "gait/gait.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gait/random_genome.h"
#include "made_robot.h"

namespace hexapod {
namespace {

std::vector<double> anglesAt(const RobotDescription& robot, const Genome& genome, double time_s) {
  std::vector<double> angles;
  Gait(robot, genome).angles(time_s, angles);
  return angles;
}

TEST(GaitSignal, IsEquationThreeByHand) {
  // At a quarter period sin is 1: gamma = alpha tanh(4) = 0.5 * 0.99932930 = 0.49966465.
  EXPECT_NEAR(gaitSignal(0.25, 0.5, 0.0), 0.49966465, 1e-8);
  // At a twelfth sin is 1/2: tanh(2) = 0.96402758.
  EXPECT_NEAR(gaitSignal(1.0 / 12.0, 1.0, 0.0), 0.96402758, 1e-8);
  EXPECT_EQ(gaitSignal(0.0, 1.0, 0.0), 0.0);
}

TEST(GaitSignal, HasAPeriodOfOneSecondAndPhaseIsATimeShift) {
  for (double t = 0.0; t < 1.0; t += 0.037) {
    EXPECT_NEAR(gaitSignal(t, 0.75, 0.25), gaitSignal(t + 1.0, 0.75, 0.25), 1e-12);
    EXPECT_NEAR(gaitSignal(t, 0.75, 0.25), gaitSignal(t + 0.25, 0.75, 0.0), 1e-12);
    EXPECT_NEAR(gaitSignal(t, 0.75, 0.5), -gaitSignal(t, 0.75, 0.0), 1e-12);
    EXPECT_LE(std::abs(gaitSignal(t, 0.75, 0.0)), 0.75);
  }
}

TEST(Gait, ZeroAmplitudesAreTheNeutralPoseExactly) {
  const RobotDescription robot = madeRobot(6, 3);
  Genome genome(24, 0);
  for (std::size_t gene = 1; gene < 24; gene += 2) genome[gene] = 3;
  for (double t : {0.0, 0.1, 0.77}) EXPECT_EQ(anglesAt(robot, genome, t), robot.neutralPose());
}

TEST(Gait, EachLegFollowsItsOwnFourGenes) {
  const RobotDescription robot = madeRobot(6, 3);
  Random random(3);
  const Genome genome = randomGenome(random);
  for (double t : {0.0, 0.06, 0.3, 0.9, 2.5}) {
    const std::vector<double> angles = anglesAt(robot, genome, t);
    for (std::size_t leg = 0; leg < 6; ++leg) {
      const double first = gaitSignal(t, 0.25 * genome[4 * leg], 0.25 * genome[4 * leg + 1]);
      const double second = gaitSignal(t, 0.25 * genome[4 * leg + 2], 0.25 * genome[4 * leg + 3]);
      EXPECT_NEAR(angles[3 * leg], 0.1 + M_PI / 8 * first, 1e-15);
      EXPECT_NEAR(angles[3 * leg + 1], 0.1 + M_PI / 4 * second, 1e-15);
      EXPECT_NEAR(angles[3 * leg + 2], 0.1 - M_PI / 4 * second, 1e-15);
    }
  }
}

TEST(Gait, MovesAQuadrupedOfTwoJointsPerLeg) {
  const RobotDescription robot = madeRobot(4, 2);
  Genome genome(16, 0);
  genome[4 * 2 + 2] = 4;  // leg 2, amplitude 2
  const std::vector<double> angles = anglesAt(robot, genome, 0.25);
  ASSERT_EQ(angles.size(), 8u);
  for (std::size_t j = 0; j < 8; ++j) {
    EXPECT_NEAR(angles[j], j == 5 ? 0.1 + M_PI / 4 * std::tanh(4.0) : 0.1, 1e-12) << j;
  }
}

TEST(Gait, ALegOfFourJointsMayHaveAThirdSignal) {
  RobotDescription robot = madeRobot(4, 4);
  for (Leg& leg : robot.legs) leg.segments[3].joint.signal = static_cast<Signal>(3);
  EXPECT_EQ(robot.signalsPerLeg(), 3u);
  EXPECT_EQ(robot.genesPerLeg(), 6u);
  Genome genome(24, 0);
  genome[6 * 1 + 4] = 4;  // leg 1, amplitude 3
  genome[6 * 1 + 5] = 1;  // a quarter of a period ahead
  const std::vector<double> angles = anglesAt(robot, genome, 0.0);
  for (std::size_t j = 0; j < 16; ++j) {
    EXPECT_NEAR(angles[j], j == 7 ? 0.1 + M_PI / 4 * std::tanh(4.0) : 0.1, 1e-12) << j;
  }
}

TEST(Gait, OfMoreLevelsHasAmplitudesAndPhasesBetweenTheFive) {
  const RobotDescription robot = madeRobot(1, 1);
  std::vector<double> angles;
  // Of 252 steps: an amplitude of 63 + 21, a phase of 21 / 252 = 1 / 12 of a period.
  Gait(robot, {84, 21, 0, 0}, 253).angles(0.0, angles);
  EXPECT_NEAR(angles[0], 0.1 + M_PI / 8 / 3.0 * std::tanh(4.0 * std::sin(M_PI / 6)), 1e-12);
  std::vector<double> five, same;
  for (const double time_s : {0.0, 0.31, 1.7}) {
    Gait(robot, {3, 1, 0, 0}).angles(time_s, five);
    Gait(robot, {189, 63, 0, 0}, 253).angles(time_s, same);
    EXPECT_EQ(five, same);
    Gait(robot, {189, 63, 0, 0}, 253).angles(gaitSignals(time_s, 253), same);
    EXPECT_EQ(five, same);
  }
}

TEST(Gait, GenomeThatDoesNotFitIsRefused) {
  const RobotDescription robot = madeRobot(4, 2);
  const auto said = [&](const Genome& genome) { return complaintOf([&] { Gait(robot, genome); }); };
  EXPECT_NE(said(Genome(24, 0)).find("24 genes does not fit robot made; expected 16"),
            std::string::npos);
  EXPECT_NE(said(Genome()).find("expected 16"), std::string::npos);
  Genome genome(16, 4);
  EXPECT_EQ(said(genome), "");
  genome[9] = 5;
  EXPECT_NE(said(genome).find("Gene 9 is 5; expected a level 0 .. 4"), std::string::npos);
}

}  // namespace
}  // namespace hexapod
