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

}  // namespace
}  // namespace hexapod
