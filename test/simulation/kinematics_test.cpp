#include "simulation/kinematics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "test_robots.h"

namespace hexapod {
namespace {

TEST(Kinematics, ChainsTheJointsOfALeg) {
  const RobotDescription robot = handMadeHexapod();
  std::vector<double> angles_rad = robot.neutralPose();
  // Leg 1 sticks out to the left from (0, 0.10); its femur is lifted by 90 degrees.
  angles_rad[4] = std::acos(0.0);
  const std::vector<Eigen::Isometry3d> poses = baseFromBodies(robot, angles_rad);
  ASSERT_EQ(poses.size(), 19u);
  EXPECT_TRUE(poses[0].isApprox(Eigen::Isometry3d::Identity()));
  EXPECT_TRUE(poses[4].translation().isApprox(Eigen::Vector3d(0.0, 0.10, 0.0)));
  EXPECT_TRUE(poses[5].translation().isApprox(Eigen::Vector3d(0.0, 0.10 + 0.06, 0.0)));
  EXPECT_TRUE(poses[6].translation().isApprox(Eigen::Vector3d(0.0, 0.16, 0.085)));
}

TEST(Kinematics, FindsTheLowestPointOfEveryShape) {
  Eigen::Isometry3d tilted(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, 0.5).normalized()));
  tilted.pretranslate(Eigen::Vector3d(0.3, -0.2, 1.0));

  Shape box;
  box.kind = Shape::Kind::kBox;
  box.size_m = Eigen::Vector3d(0.2, 0.3, 0.4);
  double lowest_corner_m = 1e9;
  for (const double x : {-0.1, 0.1}) {
    for (const double y : {-0.15, 0.15}) {
      for (const double z : {-0.2, 0.2}) {
        lowest_corner_m = std::min(lowest_corner_m, (tilted * Eigen::Vector3d(x, y, z)).z());
      }
    }
  }
  EXPECT_NEAR(lowestPoint(box, tilted), lowest_corner_m, 1e-12);

  Shape capsule;
  capsule.kind = Shape::Kind::kCapsule;
  capsule.radius_m = 0.05;
  capsule.length_m = 0.4;
  const double one_cap_m = (tilted * Eigen::Vector3d(0.0, 0.0, 0.2)).z();
  const double other_cap_m = (tilted * Eigen::Vector3d(0.0, 0.0, -0.2)).z();
  EXPECT_NEAR(lowestPoint(capsule, tilted), std::min(one_cap_m, other_cap_m) - 0.05, 1e-12);

  Shape sphere;
  sphere.radius_m = 0.1;
  EXPECT_NEAR(lowestPoint(sphere, tilted), 0.9, 1e-12);
}

TEST(Kinematics, StandsAsHighAsItsShinsAreLong) {
  EXPECT_NEAR(standingHeight(handMadeHexapod()), 0.145, 1e-12);
}

TEST(Kinematics, RefusesToStandARobotWithoutShapes) {
  RobotDescription robot = handMadeHexapod();
  robot.base.shapes.clear();
  for (Leg& leg : robot.legs) {
    for (Segment& segment : leg.segments) segment.body.shapes.clear();
  }
  EXPECT_THROW(standingHeight(robot), std::invalid_argument);
}

}  // namespace
}  // namespace hexapod
