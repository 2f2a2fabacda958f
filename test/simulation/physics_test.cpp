#include "simulation/physics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "test_robots.h"

namespace hexapod {
namespace {

std::string complaintAbout(double Physics::*value, double found) {
  Physics physics;
  physics.*value = found;
  try {
    checkPhysics(physics);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Physics, NamesTheValueThatIsOutOfRange) {
  EXPECT_EQ(complaintAbout(&Physics::step_s, 0.0),
            "Physics value step_s must be between 0.0001 and 0.1, found 0.");
  EXPECT_NE(complaintAbout(&Physics::gravity_m_per_s2, -9.81).find("gravity_m_per_s2"),
            std::string::npos);
  EXPECT_NE(complaintAbout(&Physics::friction_scale, -0.1).find("friction_scale"),
            std::string::npos);
  EXPECT_NE(complaintAbout(&Physics::mass_scale, 0.0).find("mass_scale"), std::string::npos);
  EXPECT_NE(complaintAbout(&Physics::servo_gain_scale, 1e9).find("servo_gain_scale"),
            std::string::npos);
  EXPECT_NE(complaintAbout(&Physics::torque_scale, -1.0).find("torque_scale"), std::string::npos);
  EXPECT_NE(complaintAbout(&Physics::slope_x_rad, 1.57).find("slope_x_rad"), std::string::npos);
  EXPECT_NE(complaintAbout(&Physics::slope_y_rad, std::nan("")).find("slope_y_rad"),
            std::string::npos);
  EXPECT_NO_THROW(checkPhysics(Physics()));
}

TEST(Physics, PullsStraightDownOnALevelFloor) {
  EXPECT_EQ(gravityOnFloor(Physics()), Eigen::Vector3d(0.0, 0.0, -9.81));
}

TEST(Physics, PullsBackAndToTheRightOnAFloorThatRisesToTheFrontAndLeft) {
  Physics physics;
  physics.slope_x_rad = 0.1;
  EXPECT_TRUE(gravityOnFloor(physics).isApprox(
      Eigen::Vector3d(-9.81 * std::sin(0.1), 0.0, -9.81 * std::cos(0.1)), 1e-12));
  physics.slope_x_rad = 0.0;
  physics.slope_y_rad = 0.2;
  EXPECT_TRUE(gravityOnFloor(physics).isApprox(
      Eigen::Vector3d(0.0, -9.81 * std::sin(0.2), -9.81 * std::cos(0.2)), 1e-12));
  physics.slope_x_rad = 0.1;
  EXPECT_NEAR(gravityOnFloor(physics).norm(), 9.81, 1e-12);
}

TEST(Physics, ScalesACopyOfTheRobot) {
  const RobotDescription robot = handMadeHexapod();
  Physics physics;
  physics.friction_scale = 0.5;
  physics.mass_scale = 2.0;
  physics.servo_gain_scale = 1.25;
  physics.torque_scale = 0.8;
  const RobotDescription scaled = underPhysics(robot, physics);
  EXPECT_DOUBLE_EQ(scaled.contact.friction, 0.45);
  EXPECT_DOUBLE_EQ(scaled.servo.gain_per_s, 20.0);
  EXPECT_DOUBLE_EQ(scaled.base.mass_kg, 3.0);
  const Segment& femur = scaled.legs[4].segments[1];
  EXPECT_DOUBLE_EQ(femur.body.mass_kg, 0.36);
  EXPECT_DOUBLE_EQ(femur.joint.max_torque_nm, 1.2);
  EXPECT_TRUE(
      femur.body.inertia_kg_m2.isApprox(2.0 * robot.legs[4].segments[1].body.inertia_kg_m2));
}

TEST(Physics, TellsAbsurdStates) {
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  const Eigen::Vector3d infinite(0.0, std::numeric_limits<double>::infinity(), 0.0);
  const Eigen::Vector3d undefined(0.0, 0.0, std::nan(""));
  EXPECT_FALSE(isAbsurd(Eigen::Vector3d(1e5, 0.0, 0.0), zero, zero));
  EXPECT_TRUE(isAbsurd(infinite, zero, zero));
  EXPECT_TRUE(isAbsurd(zero, undefined, zero));
  EXPECT_TRUE(isAbsurd(zero, Eigen::Vector3d(0.0, 101.0, 0.0), zero));
  EXPECT_TRUE(isAbsurd(zero, zero, Eigen::Vector3d(0.0, 1001.0, 0.0)));
}

}  // namespace
}  // namespace hexapod
