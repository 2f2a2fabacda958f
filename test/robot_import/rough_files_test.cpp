#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "imports.h"
#include "made_urdf.h"
#include "robot/dimensions.h"
#include "robot_import/leg_model.h"

namespace hexapod {
namespace {

std::string withChain(const std::string& chain) {
  return replacedAll(hexapodUrdf({}), "</robot>", chain);
}

TEST(RoughFiles, ForwardIsWhereNoLegStandsWhenNoNamesTell) {
  MadeRobot made;
  made.has_sides = false;
  made.hips_apart_m = 0.3;  // farther than front and rear hips
  const ImportResult wide = import(hexapodUrdf(made));
  EXPECT_EQ(wide.imported.forward, "x");
  EXPECT_EQ(legNames(wide.robot)[1], "left_middle");
  made.hips_apart_m = 0.16;
  made.y_forward = true;
  EXPECT_EQ(import(hexapodUrdf(made)).imported.forward, "y");
  // Round ones go where the convention says.
  EXPECT_EQ(import(roundUrdf(made, 6, 0.0)).imported.forward, "x");
}

TEST(RoughFiles, LegsAreNamedFromTheMiddleOfTheHips) {
  MadeRobot made;
  const std::vector<std::string> names = legNames(import(hexapodUrdf(made)).robot);
  made.beside_x_m = 0.4;
  const ImportResult beside = import(hexapodUrdf(made));
  expectReady(beside);
  EXPECT_EQ(legNames(beside.robot), names);
}

class Appendages : public testing::TestWithParam<std::string> {};

TEST_P(Appendages, AreNoLegs) {
  const ImportResult result = import(withChain(GetParam()));
  expectReady(result);
  EXPECT_EQ(result.robot.jointCount(), 18u);
  EXPECT_TRUE(isRemarked(result, "is not part of a leg"));
}

INSTANTIATE_TEST_SUITE_P(
    All, Appendages,
    testing::Values(chainUrdf("head", 3, 0.1, 0.07),    // by its name, as long as a leg
                    chainUrdf("link_7", 3, 0.0, 0.1),   // without a twin
                    chainUrdf("link_7", 6, 0.0, 0.05),  // of another number of hinges
                    replacedAll(chainUrdf("a", 2, 0.05, 0.05), "</robot>",
                                chainUrdf("b", 2, -0.05, 0.05))));  // a pair of them

// With legs `of` hung on a part of the body of its own, behind a joint in the frame of the base.
std::string inParts(std::string urdf, const std::vector<std::string>& of, const std::string& part) {
  for (const std::string& leg : of) {
    const std::string child = "<child link='coxa_" + leg + "'/>";
    urdf =
        replacedAll(urdf, "<parent link='base'/>" + child, "<parent link='" + part + "'/>" + child);
  }
  return replacedAll(urdf, "</robot>",
                     "<joint name='to_" + part +
                         "' type='revolute'><parent link='base'/><child link='" + part +
                         "'/><axis xyz='0 0 1'/><limit lower='-0.5' upper='0.5' effort='5' "
                         "velocity='3'/></joint><link name='" +
                         part +
                         "'><inertial><mass value='0.3'/><inertia ixx='1e-3' iyy='1e-3' izz='1e-3' "
                         "ixy='0' ixz='0' iyz='0'/></inertial></link></robot>");
}

TEST(RoughFiles, ABodyInPartsIsTakenAsOne) {
  const ImportResult whole = import(hexapodUrdf({}));
  const std::string rear = inParts(hexapodUrdf({}), {"l3", "r3"}, "rear");
  for (const std::string& urdf : {rear, inParts(rear, {"l1", "r1"}, "front")}) {
    const ImportResult result = import(urdf);
    expectReady(result);
    EXPECT_TRUE(isRemarked(result, "joins parts of the body: made fixed"));
    EXPECT_EQ(legNames(result.robot), legNames(whole.robot));
    EXPECT_EQ(result.robot.jointCount(), 18u);
  }
}

TEST(RoughFiles, ALegIsALegWhateverOneOfItsLinksIsCalled) {
  const ImportResult result = import(replacedAll(hexapodUrdf({}), "tibia_l1", "antenna_l1"));
  expectReady(result);
  EXPECT_EQ(result.robot.legs.size(), 6u);
}

TEST(RoughFiles, UnitsOfServosAreUnderstood) {
  MadeRobot made;
  made.limit_rad = 90.0;
  const ImportResult degrees =
      import(replacedAll(hexapodUrdf(made), "velocity='6'", "velocity='3e-05'"));
  expectReady(degrees);
  EXPECT_TRUE(isRemarked(degrees, "has the limits -90 .. 90, taken as degrees"));
  EXPECT_TRUE(isRemarked(degrees, "slower than any servo: taken as 6.28 rad/s"));
  EXPECT_NEAR(degrees.robot.legs[0].segments[0].joint.upper_rad, 0.5 * M_PI, 1e-9);
  made.velocity_rad_per_s = 0.4;  // slow, but a servo
  EXPECT_FALSE(isRemarked(import(hexapodUrdf(made)), "slower than any servo"));
}

TEST(RoughFiles, JointsWithoutEndAndWithoutLimitsTurnAllTheWay) {
  std::string urdf = replacedAll(hexapodUrdf({}), "type='revolute'", "type='continuous'");
  urdf = replacedAll(urdf, "<limit lower='-1.6' upper='1.6' effort='2' velocity='6'/>", "");
  const ImportResult result = import(urdf);
  expectReady(result);
  EXPECT_TRUE(isRemarked(result, "is continuous: its limits are taken as -pi .. pi"));
  EXPECT_FALSE(isRemarked(result, "no usable limits"));
}

TEST(RoughFiles, LegsOfTwoHingesStepAndLift) {
  MadeRobot made;
  made.effort_nm = 8.0;
  for (const int legs : {6, 8}) {
    const ImportResult result = import(twoHingeUrdf(made, legs));
    EXPECT_EQ(result.to_change, "");
    for (const Leg& leg : result.robot.legs) {
      EXPECT_EQ(leg.segments[0].joint.signal, Signal::kFirst) << leg.name;
      EXPECT_EQ(leg.segments[1].joint.signal, Signal::kSecond) << leg.name;
      EXPECT_GT(std::abs(leg.segments[0].joint.amplitude_rad), 0.1) << leg.name;
      EXPECT_GT(std::abs(leg.segments[1].joint.amplitude_rad), 0.1) << leg.name;
    }
  }
}

TEST(RoughFiles, LegsAheadAndBehindStepAlongToo) {
  for (const int legs : {5, 6}) {
    const ImportResult result = import(roundUrdf({}, legs, 0.0));
    expectReady(result);
    for (const Leg& leg : result.robot.legs) {
      std::vector<double> back, ahead;
      for (const Segment& segment : leg.segments) {
        const Joint& joint = segment.joint;
        const double way_rad = joint.signal == Signal::kFirst ? joint.amplitude_rad : 0.0;
        back.push_back(joint.neutral_rad - way_rad);
        ahead.push_back(joint.neutral_rad + way_rad);
      }
      const LegModel model(leg);
      const Eigen::Vector3d step_m = model.at(ahead).foot_m - model.at(back).foot_m;
      EXPECT_GT(step_m.x(), 0.2 * model.reach_m()) << leg.name;
      EXPECT_LT(std::abs(step_m.y()), 0.3 * step_m.x()) << leg.name;
    }
  }
}

TEST(RoughFiles, LegsDoNotReachUnderTheBody) {
  MadeRobot made;
  made.effort_nm = 8.0;
  made.limit_rad = 10.0;
  for (const Leg& leg : import(quadrupedUrdf(made)).robot.legs) {
    std::vector<double> neutral;
    for (const Segment& segment : leg.segments) neutral.push_back(segment.joint.neutral_rad);
    const LegModel model(leg);
    EXPECT_GT(model.at(neutral).foot_m.y() * model.hip_m().y(), 0.0) << leg.name;
  }
}

TEST(RoughFiles, MissingMeshesAreGuessedLinkByLink) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "hexapod_missing_meshes";
  std::filesystem::create_directories(folder);
  MadeRobot made;
  made.mesh_folder = folder.string();
  made.has_frames = true;
  const std::string urdf = hexapodUrdf(made);
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().filename().string().rfind("tibia", 0) == 0) std::filesystem::remove(file);
  }
  const ImportResult partly = import(urdf, folder.string());
  expectReady(partly);
  EXPECT_NEAR(legReach_m(partly.robot), 0.27, 0.01);
  std::filesystem::remove_all(folder);
  // Without masses, frames and meshes only the joints tell; the tibia is taken as long as the
  // femur.
  made.has_frames = false;
  const ImportResult bare = import(without(hexapodUrdf(made), "inertial"), "/nowhere");
  expectReady(bare);
  EXPECT_TRUE(isRemarked(bare, "has nothing that tells where it ends"));
  EXPECT_NEAR(legReach_m(bare.robot), 0.05 + 0.09 + 0.09, 0.01);
}

TEST(RoughFiles, AShinThatIsOnlyAMassIsGuessedFromIt) {
  std::string urdf = hexapodUrdf({});
  const std::string shin = "<link name='tibia_";
  for (std::size_t at = urdf.find(shin); at != std::string::npos; at = urdf.find(shin, at + 1)) {
    const std::size_t length = urdf.find("</link>", at) - at;
    urdf.replace(at, length, without(without(urdf.substr(at, length), "visual"), "collision"));
  }
  const ImportResult result = import(urdf);
  expectReady(result);
  EXPECT_NEAR(legReach_m(result.robot), 0.27, 0.01);
  EXPECT_TRUE(isRemarked(result, "has no shape that could be read"));
}

TEST(RoughFiles, TheNearestLegIsNamedWhereLeftAndRightDiffer) {
  // The front left hip, a centimetre back.
  const ImportResult result =
      import(replacedAll(hexapodUrdf({}), "xyz='0.1 0.08 0'", "xyz='0.09 0.08 0'"));
  EXPECT_NE(result.not_mirrored.find("the nearest, j_coxa_r1, is at (0.1 -0.08 0) m"),
            std::string::npos)
      << result.not_mirrored;
}

TEST(RoughFiles, HalvesOfALinkageAreTold) {
  std::string urdf = replacedAll(quadrupedUrdf({}), "effort='2'", "effort='20'");
  EXPECT_FALSE(isRemarked(import(urdf), "side by side"));
  urdf = replacedAll(urdf, "xyz='-0.18 0.07 0'", "xyz='0.12 0.07 0'");
  EXPECT_TRUE(isRemarked(import(urdf), "left_rear with left_front turns about one axis"));
}

TEST(RoughFiles, WhatCannotStandIsRefusedWithTheReason) {
  MadeRobot made;
  made.limit_rad = 0.05;
  EXPECT_NE(complaint(hexapodUrdf(made)).find("do not all reach below its body"),
            std::string::npos);
  const std::string loop =
      "<joint name='bar' type='revolute'><parent link='tibia_l1'/><child link='tibia_l2'/><axis "
      "xyz='0 1 0'/><limit lower='-1' upper='1' effort='1' velocity='1'/></joint></robot>";
  EXPECT_NE(complaint(withChain(loop)).find("below two joints, bar and j_tibia_l2: a closed loop"),
            std::string::npos);
  made = {};
  made.scale = 1000.0;
  EXPECT_NE(complaint(hexapodUrdf(made)).find("Are its lengths in millimetres?"),
            std::string::npos);
  EXPECT_NE(complaint(roundUrdf({}, 2, 0.0)).find("expected three or more"), std::string::npos);
  // The base link's y is up.
  std::string turned =
      "<robot name='turned'><link name='root'/><joint name='turn' type='fixed'>"
      "<parent link='root'/><child link='base'/><origin rpy='1.5708 0 0'/></joint>";
  turned = replacedAll(hexapodUrdf({}), "<robot name='made'>", turned);
  EXPECT_NE(complaint(turned).find("z is up"), std::string::npos);
}

}  // namespace
}  // namespace hexapod
