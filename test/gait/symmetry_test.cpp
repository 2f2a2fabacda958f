#include "gait/symmetry.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gait/behavior.h"
#include "gait/random_genome.h"
#include "made_robot.h"

namespace hexapod {
namespace {

/// A leg of one joint: hip at (x, y), swinging about `axis_z` * z, foot outwards.
Leg oar(double x_m, double y_m, double axis_z) {
  Leg leg;
  leg.segments.resize(1);
  Joint& joint = leg.segments[0].joint;
  joint.parent_from_joint.translation() << x_m, y_m, 0.0;
  joint.axis << 0.0, 0.0, axis_z;
  joint.lower_rad = -1.0;
  joint.upper_rad = 1.0;
  joint.amplitude_rad = 0.5;
  leg.segments[0].body.mass_kg = 0.1;
  leg.segments[0].body.center_of_mass_m << 0.0, y_m > 0.0 ? 0.1 : -0.1, 0.0;
  return leg;
}

/// Legs: left front, left rear, right front, right rear. All axes up.
RobotDescription fourOars() {
  RobotDescription robot;
  robot.legs = {oar(0.1, 0.1, 1.0), oar(-0.1, 0.1, 1.0), oar(0.1, -0.1, 1.0), oar(-0.1, -0.1, 1.0)};
  return robot;
}

std::vector<std::string> namesOf(const std::vector<Symmetry>& symmetries) {
  std::vector<std::string> names;
  for (const Symmetry& symmetry : symmetries) names.push_back(symmetry.name());
  return names;
}

using Names = std::vector<std::string>;

TEST(Symmetry, ExchangesLegsAndShiftsMirroredJointsByHalfAPeriod) {
  const auto symmetries = symmetriesOf(fourOars());
  ASSERT_EQ(namesOf(symmetries), (Names{"left-right", "fore-aft", "half turn"}));
  const Genome genome = {4, 1, 0, 0, 3, 2, 0, 0, 2, 3, 0, 0, 1, 0, 0, 0};
  // Both axes point up: the mirror image of turning left is turning right, half a period away.
  EXPECT_EQ(symmetries[0].image(genome), (Genome{2, 1, 0, 0, 1, 2, 0, 0, 4, 3, 0, 0, 3, 0, 0, 0}));
  EXPECT_EQ(symmetries[1].image(genome), (Genome{3, 0, 0, 0, 4, 3, 0, 0, 1, 2, 0, 0, 2, 1, 0, 0}));
  // Turned, an axis up stays an axis up.
  EXPECT_EQ(symmetries[2].image(genome), (Genome{1, 0, 0, 0, 2, 3, 0, 0, 3, 2, 0, 0, 4, 1, 0, 0}));
}

TEST(Symmetry, KeepsThePhaseWhereTheOtherSidesAxisPointsDown) {
  RobotDescription robot = fourOars();
  robot.legs[2] = oar(0.1, -0.1, -1.0);
  robot.legs[3] = oar(-0.1, -0.1, -1.0);
  const auto symmetries = symmetriesOf(robot);
  ASSERT_EQ(symmetries.size(), 3u);
  const Genome genome = {4, 1, 0, 0, 3, 2, 0, 0, 2, 3, 0, 0, 1, 0, 0, 0};
  EXPECT_EQ(symmetries[0].image(genome), (Genome{2, 3, 0, 0, 1, 0, 0, 0, 4, 1, 0, 0, 3, 2, 0, 0}));
}

TEST(Symmetry, TakesANegatedAmplitudeForANegatedAxis) {
  RobotDescription robot = fourOars();
  for (const std::size_t right : {2, 3}) robot.legs[right].segments[0].joint.amplitude_rad = -0.5;
  const auto legs = symmetriesOf(robot)[0].legs();
  for (const auto& leg : legs) EXPECT_FALSE(leg.half_period[0]);
}

TEST(Symmetry, OfAnImageIsTheGenomeAgain) {
  Random random(3);
  for (const Symmetry& symmetry : symmetriesOf(fourOars())) {
    for (int i = 0; i < 100; ++i) {
      const Genome genome = canonical(randomGenome(random, 16));
      EXPECT_EQ(symmetry.image(symmetry.image(genome)), genome) << symmetry.name();
    }
  }
}

TEST(Symmetry, ShiftsByHalfAPeriodInWhateverLevels) {
  const Symmetry left_right = symmetriesOf(fourOars(), 253)[0];
  Genome genome(16, 0);
  genome[0] = 17;
  genome[1] = 130;
  // A period is 252 steps: 130 + 126 = 256, which is 4 steps into the next one.
  EXPECT_EQ(left_right.image(genome), (Genome{0, 0, 0, 0, 0, 0, 0, 0, 17, 4, 0, 0, 0, 0, 0, 0}));
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    Genome drawn(16);
    for (auto& level : drawn) level = static_cast<std::uint8_t>(random.below(253));
    EXPECT_EQ(left_right.image(left_right.image(drawn)), canonical(drawn, 253));
  }
}

TEST(Symmetry, ExchangesAllSignalsOfALeg) {
  RobotDescription robot = fourOars();
  for (Leg& leg : robot.legs) leg.segments[0].joint.signal = static_cast<Signal>(3);
  ASSERT_EQ(robot.geneCount(), 24u);
  const Symmetry left_right = symmetriesOf(robot)[0];
  EXPECT_EQ(left_right.legs()[0].half_period, (std::vector<bool>{false, false, true}));
  Genome genome(24, 0);
  genome[2] = genome[4] = 3;  // leg 0: amplitude 2, amplitude 3
  genome[3] = genome[5] = 1;
  Genome expected(24, 0);
  expected[14] = expected[16] = 3;  // leg 2
  expected[15] = 1;
  expected[17] = 3;
  EXPECT_EQ(left_right.image(genome), expected);
}

TEST(Symmetry, MirrorsEndPosesAndNothingElseOfAnOutcome) {
  const auto symmetries = symmetriesOf(fourOars());
  const Outcome outcome = walkedTo({0.3, 0.1, 0.5});
  const std::vector<Pose2> expected = {{0.3, -0.1, -0.5}, {-0.3, 0.1, -0.5}, {-0.3, -0.1, 0.5}};
  for (std::size_t i = 0; i < symmetries.size(); ++i) {
    const Outcome image = symmetries[i].image(outcome);
    EXPECT_EQ(image.verdict, Verdict::kWalked);
    EXPECT_EQ(image.cost, outcome.cost);
    EXPECT_EQ(image.end_pose.x_m, expected[i].x_m);
    EXPECT_EQ(image.end_pose.y_m, expected[i].y_m);
    EXPECT_EQ(image.end_pose.yaw_rad, expected[i].yaw_rad);
    // The mirrored arc is as well met as the arc.
    EXPECT_EQ(walkedTo(image.end_pose).cost, outcome.cost);
  }
  EXPECT_EQ(symmetries[0].image(Outcome{Verdict::kFell, {}, 0.0}).verdict, Verdict::kFell);
}

TEST(Symmetry, MovesJointsAsTheMirrorImageDoes) {
  const RobotDescription robot = fourOars();
  Random random(5);
  BehaviorOptions options;
  options.return_duration_s = 0.6;
  RobotDescription fast = robot;
  for (Leg& leg : fast.legs) leg.segments[0].joint.max_velocity_rad_per_s = 6.28;
  const Symmetry left_right = symmetriesOf(fast)[0];
  for (int i = 0; i < 20; ++i) {
    const Genome genome = canonical(randomGenome(random, 16));
    const Behavior behavior(fast, genome, options);
    const Behavior image(fast, left_right.image(genome), options);
    for (std::size_t k = 0; k < behavior.commandCount(); ++k) {
      for (std::size_t leg = 0; leg < 4; ++leg) {
        EXPECT_NEAR(image.command(k)[(leg + 2) % 4], -behavior.command(k)[leg], 1e-12);
      }
    }
  }
}

struct Defect {
  std::string name;
  void (*apply)(RobotDescription&);
  Names left;  ///< symmetries that survive it
};

class Asymmetry : public testing::TestWithParam<Defect> {};

TEST_P(Asymmetry, IsDetected) {
  RobotDescription robot = fourOars();
  GetParam().apply(robot);
  EXPECT_EQ(namesOf(symmetriesOf(robot)), GetParam().left);
}

Joint& firstJoint(RobotDescription& robot) { return robot.legs[0].segments[0].joint; }
Body& firstBody(RobotDescription& robot) { return robot.legs[0].segments[0].body; }

const Defect kDefects[] = {
    {"leg_mass", [](RobotDescription& r) { firstBody(r).mass_kg = 0.2; }, {}},
    {"leg_inertia", [](RobotDescription& r) { firstBody(r).inertia_kg_m2(0, 0) = 0.1; }, {}},
    {"hip",
     [](RobotDescription& r) { firstJoint(r).parent_from_joint.translation()[0] += 0.01; },
     {}},
    {"axis", [](RobotDescription& r) { firstJoint(r).axis << 1, 0, 0; }, {}},
    {"amplitude", [](RobotDescription& r) { firstJoint(r).amplitude_rad = 0.4; }, {}},
    {"limit", [](RobotDescription& r) { firstJoint(r).upper_rad = 0.9; }, {}},
    {"torque", [](RobotDescription& r) { firstJoint(r).max_torque_nm = 1.0; }, {}},
    {"velocity", [](RobotDescription& r) { firstJoint(r).max_velocity_rad_per_s = 1.0; }, {}},
    {"signal", [](RobotDescription& r) { firstJoint(r).signal = Signal::kSecond; }, {}},
    {"shape", [](RobotDescription& r) { firstBody(r).shapes.resize(1); }, {}},
    {"leg_missing", [](RobotDescription& r) { r.legs.pop_back(); }, {}},
    {"cargo_in_front",
     [](RobotDescription& r) { r.base.center_of_mass_m << 0.05, 0.0, 0.0; },
     {"left-right"}},
    {"cargo_left",
     [](RobotDescription& r) { r.base.center_of_mass_m << 0.0, 0.05, 0.0; },
     {"fore-aft"}},
    {"skewed_base",
     [](RobotDescription& r) { r.base.inertia_kg_m2(0, 1) = r.base.inertia_kg_m2(1, 0) = 0.01; },
     {"half turn"}},
};

INSTANTIATE_TEST_SUITE_P(Defects, Asymmetry, testing::ValuesIn(kDefects),
                         [](const auto& info) { return info.param.name; });

TEST(Symmetry, IsFoundInRobotsWhoseFilesRoundAngles) {
  RobotDescription robot = fourOars();
  // 2.3516 instead of 2.35158 rad.
  robot.legs[2].segments[0].joint.parent_from_joint.rotate(
      Eigen::AngleAxisd(2e-5, Eigen::Vector3d::UnitX()));
  EXPECT_EQ(symmetriesOf(robot).size(), 3u);
  EXPECT_EQ(whyNotMirrored(robot), "");
}

TEST(Symmetry, TellsWhatIsNoMirrorImage) {
  RobotDescription robot = fourOars();
  robot.legs[0].name = "left_front";
  robot.legs[0].segments[0].joint.name = "shoulder";
  robot.legs[0].segments[0].joint.upper_rad = 1.1;
  EXPECT_TRUE(namesOf(symmetriesOf(robot)) == Names{});
  EXPECT_EQ(whyNotMirrored(robot),
            "leg left_front has no image: the way from neutral to one limit of joint shoulder is "
            "-1.1 rad, that of its image -1 rad");
}

}  // namespace
}  // namespace hexapod
