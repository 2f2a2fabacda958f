#include "robot_import/import_robot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "imports.h"
#include "made_urdf.h"
#include "robot/dimensions.h"
#include "robot/load_robot.h"
#include "robot_import/leg_model.h"

namespace hexapod {
namespace {

// The foot's way from signal -1 to 1, in the base.
Eigen::Vector3d stroke(const Leg& leg, Signal signal) {
  const LegModel model(leg);
  std::vector<double> at_low, at_high;
  for (const Segment& segment : leg.segments) {
    const Joint& joint = segment.joint;
    const double reach_rad = joint.signal == signal ? joint.amplitude_rad : 0.0;
    at_low.push_back(joint.neutral_rad - reach_rad);
    at_high.push_back(joint.neutral_rad + reach_rad);
  }
  return model.at(at_high).foot_m - model.at(at_low).foot_m;
}

TEST(ImportRobot, PlainHexapodNeedsNothingButAGait) {
  const ImportResult result = import(hexapodUrdf({}));
  expectReady(result);
  EXPECT_TRUE(result.remarks.empty());
  EXPECT_EQ(result.not_mirrored, "");
  EXPECT_EQ(result.imported.forward, "x");
  EXPECT_EQ(legNames(result.robot),
            (std::vector<std::string>{"left_rear", "left_middle", "left_front", "right_front",
                                      "right_middle", "right_rear"}));
  EXPECT_EQ(result.robot.legs[2].segments[0].joint.name, "j_coxa_l1");
}

TEST(ImportRobot, SignalsMoveTheFootAlongAndUpAndTheTibiaStaysUpright) {
  const ImportResult result = import(hexapodUrdf({}));
  for (const Leg& leg : result.robot.legs) {
    const Eigen::Vector3d along = stroke(leg, Signal::kFirst);
    EXPECT_GT(along.x(), 0.2 * reach_m(leg)) << leg.name;
    EXPECT_LT(std::abs(along.z()), 0.1 * along.norm()) << leg.name;
    const Eigen::Vector3d up = stroke(leg, Signal::kSecond);
    EXPECT_GT(up.z(), 0.2 * reach_m(leg)) << leg.name;
    EXPECT_LT(up.head<2>().norm(), 0.4 * up.z()) << leg.name;
    const LegPose pose =
        LegModel(leg).at({leg.segments[0].joint.neutral_rad, leg.segments[1].joint.neutral_rad,
                          leg.segments[2].joint.neutral_rad});
    const Eigen::Vector3d tibia = (pose.foot_m - pose.joint_m[2]).normalized();
    EXPECT_LT(tibia.z(), -0.85) << leg.name;
  }
}

TEST(ImportRobot, SaysWhatTheLearnersOptionsDoNotSuit) {
  ImportResult result = import(hexapodUrdf({}));
  EXPECT_EQ(reportOf(result).find("learn with"), std::string::npos);
  result.gaits.median_shift_m = 0.11 * legReach_m(result.robot);
  EXPECT_NE(reportOf(result).find("learn with step_s 0.005"), std::string::npos);
  result.gaits.back_to_neutral_s = 1.0;  // 0.1 s after way back and rest: 4 commands of 30 ms
  EXPECT_NE(reportOf(result).find("learn with rest_duration_s 0.42"), std::string::npos);
}

TEST(ImportRobot, WrittenFilesLoadAsTheRobotThatWasTried) {
  MadeRobot made;
  made.has_frames = made.has_box_legs = made.y_forward = true;
  const ImportResult result = import(hexapodUrdf(made));
  EXPECT_EQ(parseRobot(result.urdf, result.yaml, "a", "b").digest, result.robot.digest);
  // Frames that others may want to look up are still there.
  EXPECT_NE(result.urdf.find("<link name=\"imu\"/>"), std::string::npos);
}

TEST(ImportRobot, QuadrupedStandsOnBentLegs) {
  MadeRobot made;
  made.effort_nm = 8.0;
  const ImportResult result = import(quadrupedUrdf(made));
  expectReady(result);
  EXPECT_EQ(result.not_mirrored, "");
  EXPECT_EQ(legNames(result.robot),
            (std::vector<std::string>{"left_rear", "left_front", "right_front", "right_rear"}));
  EXPECT_LT(result.standing.height_m, 0.3);
}

TEST(ImportRobot, RoundRobotsOfFiveAndSixLegsStand) {
  MadeRobot made;
  made.has_disc_body = true;
  for (const int legs : {5, 6}) {
    const ImportResult result = import(roundUrdf(made, legs, 0.0));
    expectReady(result);
    EXPECT_EQ(result.not_mirrored, "") << legs;
    EXPECT_TRUE(isRemarked(result, "simulated as bars across it"));
  }
}

TEST(ImportRobot, TenLegsAreFewEnough) {
  MadeRobot made;
  made.legs_per_side = 5;
  made.scale = 1.0;
  const ImportResult result = import(hexapodUrdf(made));
  EXPECT_EQ(result.to_change, "");
  EXPECT_EQ(result.gaits.engine, "reduced");
  EXPECT_EQ(result.robot.legs.front().name, "left_5");
}

TEST(ImportRobot, FramesWorldsWideLimitsAndAbsurdInertiasAreUnderstood) {
  MadeRobot made;
  made.has_frames = made.has_world = true;
  made.has_inertias = false;
  made.limit_rad = 10.0;
  const ImportResult result = import(hexapodUrdf(made));
  expectReady(result);
  for (const char* remark :
       {"link world is a frame above the robot", "taken as -3.14159 .. 3.14159 rad",
        "has no possible inertia: taken from its shapes and mass",
        "has an inertia far beyond its shapes: replaced"}) {
    EXPECT_TRUE(isRemarked(result, remark)) << remark;
  }
  // One sentence per kind of change.
  EXPECT_EQ(result.remarks.size(), 4u) << result.remarks.back();
}

TEST(ImportRobot, MeshesOnLegsBecomeCapsulesAndBoxesStayBoxes) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "hexapod_import_meshes";
  std::filesystem::create_directories(folder);
  MadeRobot meshed;
  meshed.mesh_folder = folder.string();
  const ImportResult from_meshes = import(hexapodUrdf(meshed), folder.string());
  expectReady(from_meshes);
  EXPECT_TRUE(isRemarked(from_meshes, "has a mesh to collide with"));
  MadeRobot boxed;
  boxed.has_box_legs = true;
  const ImportResult from_boxes = import(hexapodUrdf(boxed));
  expectReady(from_boxes);
  EXPECT_FALSE(isRemarked(from_boxes, "capsule"));
  EXPECT_EQ(from_boxes.robot.legs[0].segments[2].body.shapes[0].kind, Shape::Kind::kBox);
  EXPECT_EQ(from_meshes.robot.legs[0].segments[2].body.shapes[0].kind, Shape::Kind::kCapsule);
  // The same limbs either way, but for corners that are farther away than the middle of an end.
  EXPECT_NEAR(legReach_m(from_meshes.robot), legReach_m(from_boxes.robot), 3e-3);
  std::filesystem::remove_all(folder);
}

TEST(ImportRobot, MeshesThatAreNotAtHandAreGuessedAndTold) {
  MadeRobot made;
  made.mesh_folder = testing::TempDir();
  const ImportResult result = import(hexapodUrdf(made), "/nowhere");
  expectReady(result);
  EXPECT_TRUE(isRemarked(result, "has a mesh that is not found; --mesh_path names the folder"));
  EXPECT_TRUE(isRemarked(result, "guessed from the joints"));
}

TEST(ImportRobot, SizesFromHalfToThreeTimesAreScaled) {
  for (const double scale : {0.5, 3.0}) {
    MadeRobot made;
    made.scale = scale;
    made.y_forward = scale < 1.0;
    made.has_collisions = scale < 1.0;
    const ImportResult result = import(hexapodUrdf(made));
    expectReady(result);
    EXPECT_EQ(result.imported.forward, scale < 1.0 ? "y" : "x");
    EXPECT_NEAR(lengthScale(result.robot), scale * 0.27 / 0.29, 0.01);
    // Slip under its own weight is that of the paper's robot.
    EXPECT_NEAR(result.robot.contact.slip_per_n_s * totalMass_kg(result.robot), 0.02 * 3.06, 1e-12);
  }
}

TEST(ImportRobot, WhatIsNoLegIsMadeFixed) {
  const std::string antenna =
      "<link name='mast'><inertial><mass value='0.01'/><inertia ixx='1e-6' iyy='1e-6' izz='1e-6' "
      "ixy='0' ixz='0' iyz='0'/></inertial></link><joint name='pan' type='revolute'><parent "
      "link='base'/><child link='mast'/><origin xyz='0 0 0.05'/><axis xyz='0 0 1'/><limit "
      "lower='-1' upper='1' effort='1' velocity='1'/></joint></robot>";
  const ImportResult result = import(replacedAll(hexapodUrdf({}), "</robot>", antenna));
  expectReady(result);
  EXPECT_EQ(result.robot.jointCount(), 18u);
  EXPECT_TRUE(isRemarked(result, "joint pan is not part of a leg: made fixed"));
}

TEST(ImportRobot, MissingEffortsAndVelocitiesAreAssumedAndTold) {
  const std::string urdf = replacedAll(hexapodUrdf({}), "effort='2'", "effort='0'");
  const ImportResult result = import(replacedAll(urdf, "velocity='6'", "velocity='0'"));
  expectReady(result);
  EXPECT_TRUE(isRemarked(result, "has no effort: taken as"));
  EXPECT_TRUE(isRemarked(result, "has no velocity: taken as 6.28 rad/s"));
}

TEST(ImportRobot, ImpossibleRobotsAreRefusedWithTheReason) {
  MadeRobot weak;
  weak.effort_nm = 0.02;
  EXPECT_NE(complaint(hexapodUrdf(weak)).find("cannot carry the robot"), std::string::npos);
  EXPECT_NE(complaint("<robot name='stone'><link name='stone'/></robot>").find("has no legs"),
            std::string::npos);
  const std::string empty =
      without(without(without(hexapodUrdf({}), "inertial"), "visual"), "collision");
  EXPECT_NE(complaint(empty).find("has neither shape nor mass"), std::string::npos);
}

TEST(ImportRobot, ReportTellsWhereFeetGoAndThatItIsReady) {
  const std::string report = reportOf(import(hexapodUrdf({})));
  for (const char* part : {"6 legs, 18 joints", "left_front: signal 1 (", "Stands 0.1",
                           "Left and right are mirror images.", "Of 24 random gaits",
                           "between steps of 15 and 5 ms", "Engine reduced", "Ready to learn."}) {
    EXPECT_NE(report.find(part), std::string::npos) << part << "\n" << report;
  }
}

}  // namespace
}  // namespace hexapod
