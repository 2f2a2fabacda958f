#include <gtest/gtest.h>

#include <cmath>

#include "shipped_files.h"

namespace hexapod {
namespace {

// A URDF link that is a solid cube of 0.1 m and 1.2 kg: m (a^2 + a^2) / 12 = 0.002 kg m^2.
std::string cube(const std::string& name) {
  return "<link name='" + name +
         "'><inertial><mass value='1.2'/><inertia ixx='0.002' iyy='0.002' izz='0.002' ixy='0' "
         "ixz='0' iyz='0'/></inertial><collision><geometry><box size='0.1 0.1 0.1'/></geometry>"
         "</collision></link>\n";
}

std::string joint(const std::string& name, const std::string& type, const std::string& parent,
                  const std::string& child, const std::string& origin) {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent +
         "'/><child link='" + child + "'/><origin " + origin +
         "/><axis xyz='0 2 0'/><limit lower='-1' upper='1.2' effort='2' velocity='5'/></joint>\n";
}

// Four legs of two joints around a cube; leg 3 has a gait of its own.
std::string quadrupedUrdf() {
  std::string urdf = "<robot name='quadruped'>\n" + cube("trunk");
  for (int leg = 0; leg < 4; ++leg) {
    const std::string i = std::to_string(leg);
    urdf += cube("upper_" + i) + cube("lower_" + i);
    urdf += joint("hip_" + i, "revolute", "trunk", "upper_" + i, "xyz='0 0.3 0'");
    urdf += joint("knee_" + i, "revolute", "upper_" + i, "lower_" + i, "xyz='0 0 -0.2'");
  }
  return urdf + "</robot>\n";
}

std::string restOfYaml() {
  return "servo: {gain_per_s: 10.0, dead_zone_rad_per_s: 0.0}\n"
         "contact: {friction: 0.5, slip_per_n_s: 0.0, soft_erp: 0.2, soft_cfm: 0.0,\n"
         "  max_correcting_velocity_m_per_s: 1.0, joint_erp: 0.2, joint_cfm: 0.0}\n"
         "failure: {max_base_height_m: 2.0}\n";
}

std::string quadrupedYaml() {
  std::string yaml =
      "name: quadruped\nbase_link: trunk\n"
      "gait:\n"
      "  - {signal: 1, neutral_rad: 0.1, amplitude_rad: 0.5}\n"
      "  - {signal: 2, neutral_rad: -0.2, amplitude_rad: -0.4}\n"
      "legs:\n";
  for (int leg = 0; leg < 4; ++leg) {
    const std::string i = std::to_string(leg);
    yaml += "  - name: leg_" + i + "\n    joints: [hip_" + i + ", knee_" + i + "]\n";
  }
  yaml +=
      "    gait:\n"
      "      - {signal: 2, neutral_rad: 0.0, amplitude_rad: 1}\n"
      "      - {signal: 1, neutral_rad: 0.3, amplitude_rad: 0.0}\n";
  return yaml + restOfYaml();
}

TEST(OtherRobot, QuadrupedOfTwoJointsPerLegLoads) {
  const RobotDescription robot =
      parseRobot(quadrupedUrdf(), quadrupedYaml(), "quadruped.urdf", "quadruped.yaml");
  ASSERT_EQ(robot.legs.size(), 4u);
  EXPECT_EQ(robot.jointCount(), 8u);
  EXPECT_EQ(robot.geneCount(), 16u);
  EXPECT_EQ(robot.jointNames()[5], "knee_2");
  EXPECT_EQ(robot.neutralPose(), (std::vector<double>{0.1, -0.2, 0.1, -0.2, 0.1, -0.2, 0.0, 0.3}));
  const Joint& hip = robot.legs[0].segments[0].joint;
  EXPECT_EQ(hip.axis, Eigen::Vector3d::UnitY());
  EXPECT_EQ(hip.lower_rad, -1.0);
  EXPECT_EQ(hip.upper_rad, 1.2);
  EXPECT_EQ(hip.max_torque_nm, 2.0);
  EXPECT_EQ(hip.max_velocity_rad_per_s, 5.0);
  EXPECT_EQ(robot.servo.gain_per_s, 10.0);
  EXPECT_EQ(robot.contact.friction, 0.5);
  EXPECT_EQ(robot.failure.max_base_height_m, 2.0);
}

TEST(OtherRobot, LegWithItsOwnGaitUsesIt) {
  const RobotDescription robot = parseRobot(quadrupedUrdf(), quadrupedYaml(), "a", "b");
  EXPECT_EQ(robot.legs[3].segments[0].joint.signal, Signal::kSecond);
  EXPECT_EQ(robot.legs[3].segments[0].joint.amplitude_rad, 1.0);
  EXPECT_EQ(robot.legs[2].segments[0].joint.signal, Signal::kFirst);
  EXPECT_EQ(robot.legs[2].segments[0].joint.amplitude_rad, 0.5);
}

TEST(OtherRobot, OneLegOfOneJointLoads) {
  const std::string urdf = "<robot name='hopper'>" + cube("trunk") + cube("foot") +
                           joint("hip", "revolute", "trunk", "foot", "xyz='0 0 -0.2'") + "</robot>";
  const std::string yaml =
      "name: hopper\nbase_link: trunk\ngait: [{signal: 1, neutral_rad: 0, amplitude_rad: 0.5}]\n"
      "legs: [{name: only, joints: [hip]}]\n" +
      restOfYaml();
  EXPECT_EQ(parseRobot(urdf, yaml, "a", "b").jointCount(), 1u);
}

TEST(OtherRobot, FixedLinksBecomePartOfTheBodyTheyAreFixedTo) {
  // A second cube fixed to the foot 0.3 m along x and turned by 90 degrees, a massless link between
  // them; the hinge of the leg below hangs on that second cube.
  const std::string urdf =
      "<robot name='hopper'>" + cube("trunk") + cube("thigh") + cube("plate") + cube("foot") +
      "<link name='between'/>" + joint("hip", "revolute", "trunk", "thigh", "xyz='0 0 -0.2'") +
      joint("weld_1", "fixed", "thigh", "between", "xyz='0.1 0 0' rpy='0 0 1.5707963267948966'") +
      joint("weld_2", "fixed", "between", "plate", "xyz='0 -0.2 0'") +
      joint("knee", "revolute", "plate", "foot", "xyz='0.05 0 0'") + "</robot>";
  const std::string yaml =
      "name: hopper\nbase_link: trunk\n"
      "gait: [{signal: 1, neutral_rad: 0, amplitude_rad: 0.5}, "
      "{signal: 2, neutral_rad: 0, amplitude_rad: 0.5}]\n"
      "legs: [{name: only, joints: [hip, knee]}]\n" +
      restOfYaml();
  const RobotDescription robot = parseRobot(urdf, yaml, "a", "b");
  const Body& thigh = robot.legs[0].segments[0].body;
  EXPECT_EQ(thigh.name, "thigh");
  EXPECT_DOUBLE_EQ(thigh.mass_kg, 2.4);
  // between is at (0.1, 0, 0), its -y is +x of the thigh: plate at (0.3, 0, 0).
  EXPECT_LT((thigh.center_of_mass_m - Eigen::Vector3d(0.15, 0.0, 0.0)).norm(), 1e-12);
  // Two cubes, each 0.15 m from the common centre along x: 2 * (0.002 + 1.2 * 0.15^2) = 0.058.
  const Eigen::Vector3d moments(0.004, 0.058, 0.058);
  EXPECT_LT((thigh.inertia_kg_m2 - Eigen::Matrix3d(moments.asDiagonal())).norm(), 1e-12);
  ASSERT_EQ(thigh.shapes.size(), 2u);
  EXPECT_LT((thigh.shapes[1].body_from_shape.translation() - Eigen::Vector3d(0.3, 0, 0)).norm(),
            1e-12);
  // The knee is 0.05 m along the plate's x, which is the thigh's y.
  const Joint& knee = robot.legs[0].segments[1].joint;
  EXPECT_LT((knee.parent_from_joint.translation() - Eigen::Vector3d(0.3, 0.05, 0)).norm(), 1e-12);
}

// The hopper of two cubes with something else about it.
RobotDescription hopper(const std::string& more_urdf, const std::string& more_yaml,
                        const std::string& limit =
                            "<limit lower='-1' upper='1' effort='2' "
                            "velocity='5'/>") {
  const std::string urdf = "<robot name='hopper'>" + cube("trunk") + cube("foot") +
                           "<joint name='hip' type='revolute'><parent link='trunk'/><child "
                           "link='foot'/><origin xyz='0.1 "
                           "0 -0.2'/><axis xyz='0 1 0'/>" +
                           limit + "</joint>" + more_urdf + "</robot>";
  const std::string yaml =
      "name: hopper\nbase_link: trunk\n"
      "gait: [{signal: 1, neutral_rad: 0, amplitude_rad: 0.5}]\n"
      "legs: [{name: only, joints: [hip]}]\n" +
      more_yaml;
  return parseRobot(urdf, yaml, "hopper.urdf", "hopper.yaml");
}

TEST(OtherRobot, MasslessFramesAndPointFeetArePartOfTheBodyTheyAreFixedTo) {
  const RobotDescription robot = hopper(
      "<link name='camera'><inertial><mass value='0'/><inertia ixx='0' iyy='0' izz='0' ixy='0' "
      "ixz='0' iyz='0'/></inertial></link>" +
          joint("mount", "fixed", "trunk", "camera", "xyz='0 0 0.1'") +
          "<link name='point'><inertial><mass value='0.1'/><inertia ixx='0' iyy='0' izz='0' "
          "ixy='0' ixz='0' iyz='0'/></inertial></link>" +
          joint("sole", "fixed", "foot", "point", "xyz='0 0 -0.13'"),
      restOfYaml());
  EXPECT_DOUBLE_EQ(robot.base.mass_kg, 1.2);
  const Body& foot = robot.legs[0].segments[0].body;
  EXPECT_DOUBLE_EQ(foot.mass_kg, 1.3);
  // A point of 0.1 kg 0.13 m below a cube of 1.2 kg: centre at -0.01 m; about it
  // 0.002 + 1.2 * 0.01^2 + 0.1 * 0.12^2 = 0.00356 across.
  EXPECT_NEAR(foot.center_of_mass_m.z(), -0.01, 1e-12);
  EXPECT_NEAR(foot.inertia_kg_m2(0, 0), 0.00356, 1e-12);
  EXPECT_TRUE(robot.remarks.empty());
}

TEST(OtherRobot, LimitsBeyondATurnAreTakenAsATurnWithARemark) {
  const RobotDescription robot =
      hopper("", restOfYaml(), "<limit lower='-10' upper='10' effort='2' velocity='5'/>");
  const Joint& hip = robot.legs[0].segments[0].joint;
  EXPECT_EQ(hip.lower_rad, -M_PI);
  EXPECT_EQ(hip.upper_rad, M_PI);
  ASSERT_EQ(robot.remarks.size(), 1u);
  EXPECT_EQ(robot.remarks[0],
            "hopper.urdf: joint hip has the limits -10 .. 10 rad: taken as -3.14159 .. 3.14159 "
            "rad.");
}

TEST(OtherRobot, GaitMayFillTheLimitsUpToTheirLastDigit) {
  const RobotDescription robot =
      hopper("", restOfYaml(), "<limit lower='-0.499998' upper='0.5' effort='2' velocity='5'/>");
  EXPECT_EQ(robot.legs[0].segments[0].joint.amplitude_rad, 0.5);
}

TEST(OtherRobot, DiscIsSimulatedAsBarsFromRimToRim) {
  const RobotDescription robot = hopper(
      "<link name='plate'><collision><geometry><cylinder radius='0.15' length='0.04'/></geometry>"
      "</collision></link>" +
          joint("screws", "fixed", "trunk", "plate", "xyz='0 0 0.1'"),
      restOfYaml());
  ASSERT_EQ(robot.base.shapes.size(), 4u);
  for (std::size_t i = 1; i < 4; ++i) {
    const Shape& bar = robot.base.shapes[i];
    EXPECT_EQ(bar.kind, Shape::Kind::kCapsule);
    EXPECT_DOUBLE_EQ(bar.radius_m, 0.02);
    EXPECT_DOUBLE_EQ(bar.length_m + 2.0 * bar.radius_m, 0.3);
    EXPECT_NEAR(bar.body_from_shape.linear()(2, 2), 0.0, 1e-12);
  }
  EXPECT_EQ(robot.remarks.size(), 1u);
}

TEST(OtherRobot, WorldAboveTheBaseIsNoPartOfTheRobot) {
  const RobotDescription robot = hopper(
      "<link name='world'/>" + joint("in_the_air", "floating", "world", "trunk", ""), restOfYaml());
  EXPECT_EQ(robot.base.name, "trunk");
  EXPECT_EQ(robot.jointCount(), 1u);
}

TEST(OtherRobot, ForwardAxisIsTurnedToX) {
  const RobotDescription ahead = hopper("", restOfYaml());
  const RobotDescription robot = hopper("", "forward: -y\n" + restOfYaml());
  // The hip is at x = 0.1 of the link; with -y forward, x of the link is to the left.
  EXPECT_TRUE(robot.legs[0].segments[0].joint.parent_from_joint.translation().isApprox(
      Eigen::Vector3d(0.0, 0.1, -0.2)));
  EXPECT_DOUBLE_EQ(robot.link_from_base_yaw_rad, -M_PI / 2.0);
  EXPECT_NE(robot.digest, ahead.digest);
}

TEST(OtherRobot, ContactAndHeightSuitTheRobotWhereTheYamlIsSilent) {
  const RobotDescription robot =
      hopper("",
             "servo: {gain_per_s: 10.0, dead_zone_rad_per_s: 0.0}\n"
             "contact: {friction: 0.5, soft_erp: 0.2,\n"
             "  max_correcting_velocity_m_per_s: 1.0, joint_erp: 0.2, joint_cfm: 0.0}\n"
             "failure: {}\n");
  // 2.4 kg instead of the paper's 3.06 kg.
  EXPECT_DOUBLE_EQ(robot.contact.slip_per_n_s, 0.02 * 3.06 / 2.4);
  EXPECT_DOUBLE_EQ(robot.contact.soft_cfm, 0.001 * 3.06 / 2.4);
  // The corner of the cube is sqrt(3) * 0.05 m from the hinge, which is 0.2 m below the base.
  EXPECT_NEAR(robot.failure.max_base_height_m, 0.2 + std::sqrt(3.0) * 0.05 * 0.5 / 0.29, 1e-12);
}

TEST(OtherRobot, InertiaFarBeyondTheShapesIsRemarked) {
  const RobotDescription robot = hopper(
      "<link name='ring'><inertial><mass value='1'/><inertia ixx='3' iyy='3' izz='3' ixy='0' "
      "ixz='0' iyz='0'/></inertial></link>" +
          joint("weld", "fixed", "foot", "ring", ""),
      restOfYaml());
  ASSERT_EQ(robot.remarks.size(), 1u);
  EXPECT_NE(robot.remarks[0].find("link foot has an inertia that its mass could only have far"),
            std::string::npos);
}

}  // namespace
}  // namespace hexapod
