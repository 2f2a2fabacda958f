#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "robot/dimensions.h"
#include "robot/stride.h"
#include "shipped_files.h"

namespace hexapod {
namespace {

RobotDescription shipped() { return loadRobot(kUrdfFile, kYamlFile); }

// base_from_body of the segments of a leg at the given angles.
std::vector<Eigen::Isometry3d> placed(const Leg& leg, const std::vector<double>& angles_rad) {
  std::vector<Eigen::Isometry3d> poses;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (std::size_t i = 0; i < leg.segments.size(); ++i) {
    const Joint& joint = leg.segments[i].joint;
    pose = pose * joint.parent_from_joint * Eigen::AngleAxisd(angles_rad[i], joint.axis);
    poses.push_back(pose);
  }
  return poses;
}

Eigen::Vector3d foot(const Leg& leg, const std::vector<double>& angles_rad) {
  return placed(leg, angles_rad)[2] * Eigen::Vector3d(0.0, 0.0, -0.145);
}

// Moments of a solid capsule of unit density along z, by summing thin slices: {mass, across,
// along}.
std::array<double, 3> sliced(double radius, double length) {
  const int slices = 200000;
  const double half = 0.5 * length + radius;
  const double dz = 2.0 * half / slices;
  std::array<double, 3> sum{};
  for (int i = 0; i < slices; ++i) {
    const double z = -half + (i + 0.5) * dz;
    const double beyond = std::max(0.0, std::abs(z) - 0.5 * length);
    const double r2 = radius * radius - beyond * beyond;
    const double mass = M_PI * r2 * dz;
    sum[0] += mass;
    sum[1] += mass * (0.25 * r2 + z * z);
    sum[2] += mass * 0.5 * r2;
  }
  return sum;
}

TEST(ShippedRobot, HasSixLegsOfThreeServosInTheDocumentedOrder) {
  const RobotDescription robot = shipped();
  EXPECT_EQ(robot.name, "hexapod");
  EXPECT_EQ(robot.base_link, "base_link");
  ASSERT_EQ(robot.legs.size(), 6u);
  EXPECT_EQ(robot.jointCount(), 18u);
  EXPECT_EQ(robot.geneCount(), 24u);
  const std::vector<std::string> legs = {"left_rear",   "left_middle",  "left_front",
                                         "right_front", "right_middle", "right_rear"};
  const std::vector<std::string> names = robot.jointNames();
  for (std::size_t i = 0; i < 6; ++i) {
    const std::string leg = std::to_string(i);
    EXPECT_EQ(robot.legs[i].name, legs[i]);
    EXPECT_EQ(names[3 * i], "body_leg_" + leg);
    EXPECT_EQ(names[3 * i + 1], "leg_" + leg + "_1_2");
    EXPECT_EQ(names[3 * i + 2], "leg_" + leg + "_2_3");
  }
  EXPECT_EQ(robot.neutralPose(), std::vector<double>(18, 0.0));
}

TEST(ShippedRobot, HasTheMassesOfTheRobotOf2013) {
  const RobotDescription robot = shipped();
  EXPECT_DOUBLE_EQ(robot.base.mass_kg, 1.5);
  for (const Leg& leg : robot.legs) {
    EXPECT_DOUBLE_EQ(leg.segments[0].body.mass_kg, 0.020);
    EXPECT_DOUBLE_EQ(leg.segments[1].body.mass_kg, 0.180);
    EXPECT_DOUBLE_EQ(leg.segments[2].body.mass_kg, 0.060);
  }
}

TEST(ShippedRobot, IsTheMeasureOfOtherRobots) {
  const RobotDescription robot = shipped();
  EXPECT_EQ(lengthScale(robot), 1.0);
  EXPECT_NEAR(legReach_m(robot), 0.06 + 0.085 + 0.145, 1e-12);
  EXPECT_NEAR(totalMass_kg(robot), 3.06, 1e-12);
  EXPECT_NEAR(slipFor(robot), robot.contact.slip_per_n_s, 1e-15);
  EXPECT_NEAR(softCfmFor(robot), robot.contact.soft_cfm, 1e-15);
  EXPECT_NEAR(maxBaseHeightFor(robot), robot.failure.max_base_height_m, 1e-12);
  EXPECT_TRUE(robot.remarks.empty());
}

TEST(ShippedRobot, StepsAsFarAsTheMeasureOfOtherRobots) {
  RobotDescription robot = shipped();
  // The coxa turns the foot, 0.06 + 0.085 m beside it, by pi / 8 either way.
  for (const Leg& leg : robot.legs) EXPECT_NEAR(stride_m(leg), M_PI / 8.0 * 0.145, 1e-9);
  EXPECT_EQ(strideScale(robot), 1.0);
  // Slow servos get as far as their velocity takes them in a quarter of a second.
  for (Leg& leg : robot.legs) leg.segments[0].joint.max_velocity_rad_per_s = 0.4;
  for (const Leg& leg : robot.legs) EXPECT_NEAR(stride_m(leg), 0.1 * 0.145, 1e-9);
  EXPECT_NEAR(strideScale(robot), 0.0145 / (0.19 * 0.29), 0.005);
}

TEST(ShippedRobot, StandsOnFeetBesideItsHips) {
  const RobotDescription robot = shipped();
  // Hip, then 0.06 + 0.085 m along the leg's azimuth, then 0.145 m down.
  const double hips[6][3] = {{-0.12, 0.06, 112.5}, {0.0, 0.10, 90.0},   {0.12, 0.06, 67.5},
                             {0.12, -0.06, -67.5}, {0.0, -0.10, -90.0}, {-0.12, -0.06, -112.5}};
  for (int i = 0; i < 6; ++i) {
    const double azimuth = hips[i][2] * M_PI / 180.0;
    const Eigen::Vector3d expected(hips[i][0] + 0.145 * std::cos(azimuth),
                                   hips[i][1] + 0.145 * std::sin(azimuth), -0.145);
    EXPECT_LT((foot(robot.legs[i], {0.0, 0.0, 0.0}) - expected).norm(), 1e-12) << i;
  }
}

TEST(ShippedRobot, PositiveAnglesTurnLeftLiftAndSpread) {
  const RobotDescription robot = shipped();
  for (const Leg& leg : robot.legs) {
    const Eigen::Vector3d neutral = foot(leg, {0.0, 0.0, 0.0});
    const Eigen::Vector3d hip = leg.segments[0].joint.parent_from_joint.translation();
    const Eigen::Vector3d turned = foot(leg, {0.1, 0.0, 0.0});
    EXPECT_GT((neutral - hip).cross(turned - hip).z(), 0.0) << leg.name;
    EXPECT_GT(foot(leg, {0.0, 0.1, 0.0}).z(), neutral.z()) << leg.name;
    EXPECT_GT((foot(leg, {0.0, 0.0, 0.1}) - hip).head<2>().norm(), (neutral - hip).head<2>().norm())
        << leg.name;
  }
}

TEST(ShippedRobot, OppositeLiftAndTibiaAnglesKeepTheTibiaVertical) {
  const RobotDescription robot = shipped();
  const double quarter = M_PI / 4;
  for (const Leg& leg : robot.legs) {
    const Eigen::Matrix3d tibia = placed(leg, {0.3, quarter, -quarter})[2].linear();
    EXPECT_NEAR((tibia * Eigen::Vector3d::UnitZ()).z(), 1.0, 1e-12) << leg.name;
    EXPECT_NEAR(leg.segments[0].joint.amplitude_rad, M_PI / 8, 1e-15);
    EXPECT_NEAR(leg.segments[1].joint.amplitude_rad, quarter, 1e-15);
    EXPECT_NEAR(leg.segments[2].joint.amplitude_rad, -quarter, 1e-15);
    EXPECT_EQ(leg.segments[0].joint.signal, Signal::kFirst);
    EXPECT_EQ(leg.segments[1].joint.signal, Signal::kSecond);
    EXPECT_EQ(leg.segments[2].joint.signal, Signal::kSecond);
  }
}

TEST(ShippedRobot, MirrorsLeftAndRight) {
  const RobotDescription robot = shipped();
  for (int left = 0; left < 3; ++left) {
    const std::vector<double> angles = {0.2, 0.3, -0.5};
    const std::vector<double> mirrored = {-0.2, 0.3, -0.5};
    const Eigen::Vector3d a = foot(robot.legs[left], angles);
    const Eigen::Vector3d b = foot(robot.legs[5 - left], mirrored);
    EXPECT_LT((a - Eigen::Vector3d(b.x(), -b.y(), b.z())).norm(), 1e-14) << left;
  }
}

TEST(ShippedRobot, HasLegCapsulesOfTheOverallLengthWithTheirInertia) {
  const RobotDescription robot = shipped();
  const double overall[3] = {0.06, 0.085, 0.145};
  const double radius[3] = {0.02, 0.02, 0.025};
  for (int i = 0; i < 3; ++i) {
    const Body& body = robot.legs[4].segments[i].body;
    ASSERT_EQ(body.shapes.size(), 1u);
    const Shape& shape = body.shapes[0];
    EXPECT_EQ(shape.kind, Shape::Kind::kCapsule);
    EXPECT_DOUBLE_EQ(shape.radius_m, radius[i]);
    EXPECT_NEAR(shape.length_m + 2.0 * radius[i], overall[i], 1e-15);
    EXPECT_LT((shape.body_from_shape.translation() - body.center_of_mass_m).norm(), 1e-15);

    const auto [volume, across, along] = sliced(radius[i], shape.length_m);
    const Eigen::Vector3d expected = body.mass_kg / volume * Eigen::Vector3d(across, across, along);
    const Eigen::Matrix3d rotation = shape.body_from_shape.linear();
    const Eigen::Matrix3d in_shape = rotation.transpose() * body.inertia_kg_m2 * rotation;
    EXPECT_LT((in_shape.diagonal() - expected).norm(), 1e-7 * expected.norm()) << i;
  }
}

TEST(ShippedRobot, HasABoxBodyFixedToItsMasslessBaseLink) {
  const RobotDescription robot = shipped();
  EXPECT_EQ(robot.base.name, "base_link");
  ASSERT_EQ(robot.base.shapes.size(), 1u);
  EXPECT_EQ(robot.base.shapes[0].kind, Shape::Kind::kBox);
  EXPECT_EQ(robot.base.shapes[0].size_m, Eigen::Vector3d(0.24, 0.20, 0.04));
  // m (b^2 + c^2) / 12 = 1.5 * (0.04 + 0.0016) / 12
  EXPECT_NEAR(robot.base.inertia_kg_m2(0, 0), 0.0052, 1e-12);
  EXPECT_NEAR(robot.base.inertia_kg_m2(2, 2), 1.5 * (0.0576 + 0.04) / 12.0, 1e-12);
}

TEST(ShippedRobot, HasTheServosAndContactsThatTheDefaultsDocument) {
  const RobotDescription robot = shipped();
  for (const Joint* joint : robot.joints()) {
    EXPECT_DOUBLE_EQ(joint->lower_rad, -1.57079632679);
    EXPECT_DOUBLE_EQ(joint->upper_rad, 1.57079632679);
    EXPECT_DOUBLE_EQ(joint->max_torque_nm, 1.5);
    EXPECT_DOUBLE_EQ(joint->max_velocity_rad_per_s, 6.28);
  }
  const Servo servo;
  EXPECT_EQ(robot.servo.gain_per_s, servo.gain_per_s);
  EXPECT_EQ(robot.servo.dead_zone_rad_per_s, servo.dead_zone_rad_per_s);
  const Contact contact;
  EXPECT_EQ(robot.contact.friction, contact.friction);
  EXPECT_EQ(robot.contact.slip_per_n_s, contact.slip_per_n_s);
  EXPECT_EQ(robot.contact.soft_erp, contact.soft_erp);
  EXPECT_EQ(robot.contact.soft_cfm, contact.soft_cfm);
  EXPECT_EQ(robot.contact.max_correcting_velocity_m_per_s, contact.max_correcting_velocity_m_per_s);
  EXPECT_EQ(robot.contact.joint_erp, contact.joint_erp);
  EXPECT_EQ(robot.contact.joint_cfm, 1e-14);  // stiffer than ODE's default, for the engine reduced
  EXPECT_EQ(robot.failure.max_base_height_m, FailureRules().max_base_height_m);
}

}  // namespace
}  // namespace hexapod
