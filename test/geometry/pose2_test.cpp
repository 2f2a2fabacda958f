#include "geometry/pose2.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hexapod {
namespace {

TEST(WrapAngle, MapsIntoMinusPiExclusiveToPiInclusive) {
  EXPECT_DOUBLE_EQ(wrapAngle(M_PI), M_PI);
  EXPECT_DOUBLE_EQ(wrapAngle(-M_PI), M_PI);
  EXPECT_NEAR(wrapAngle(3.0 * M_PI + 0.1), -M_PI + 0.1, 1e-12);
  EXPECT_DOUBLE_EQ(wrapAngle(0.3), 0.3);
}

TEST(Pose2, ComposesByHand) {
  // One metre ahead of a robot at (1, 2) that looks left (+y).
  const Pose2 pose = Pose2{1.0, 2.0, M_PI / 2} * Pose2{1.0, 0.0, 0.5};
  EXPECT_NEAR(pose.x_m, 1.0, 1e-12);
  EXPECT_NEAR(pose.y_m, 3.0, 1e-12);
  EXPECT_NEAR(pose.yaw_rad, M_PI / 2 + 0.5, 1e-12);
}

TEST(Pose2, InverseCancels) {
  const Pose2 pose{0.3, -1.2, 2.9};
  for (const Pose2& identity : {pose * inverse(pose), inverse(pose) * pose}) {
    EXPECT_NEAR(identity.x_m, 0.0, 1e-12);
    EXPECT_NEAR(identity.y_m, 0.0, 1e-12);
    EXPECT_NEAR(identity.yaw_rad, 0.0, 1e-12);
  }
}

TEST(Pose2, HeadingDistanceTakesTheShortWay) {
  EXPECT_NEAR(headingDistance({0, 0, 3.0}, {0, 0, -3.0}), 2.0 * M_PI - 6.0, 1e-12);
}

TEST(Footprint, IgnoresHeightRollAndPitch) {
  Eigen::Isometry3d body = Eigen::Isometry3d::Identity();
  body.translation() << 1.0, 2.0, 0.15;
  body.linear() = (Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(-0.2, Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  const Pose2 pose = footprint(body);
  EXPECT_NEAR(pose.x_m, 1.0, 1e-12);
  EXPECT_NEAR(pose.y_m, 2.0, 1e-12);
  EXPECT_NEAR(pose.yaw_rad, 0.7, 1e-12);
}

}  // namespace
}  // namespace hexapod
