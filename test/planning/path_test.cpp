#include "planning/path.h"

#include <gtest/gtest.h>

#include "arc_repertoire.h"

namespace hexapod {
namespace {

TEST(Path, IsSampledFinelyAndEndsWhereTheStepsEnd) {
  Random random(1);
  const Pose2 start = {1.0, 2.0, 0.5};
  for (int i = 0; i < 100; ++i) {
    const Pose2 first = start * randomArcEnd(random);
    const Pose2 second = first * randomArcEnd(random);
    const auto path = samplePath(start, {first, second}, 0.02);
    EXPECT_EQ(distance(path.front(), start), 0.0);
    EXPECT_NEAR(distance(path.back(), second), 0.0, 1e-12);
    for (std::size_t k = 1; k < path.size(); ++k) {
      EXPECT_LE(distance(path[k - 1], path[k]), 0.02 + 1e-9);
      EXPECT_LE(headingDistance(path[k - 1], path[k]), M_PI / 18 + 1e-9);
    }
  }
}

TEST(Path, FollowsTheArc) {
  // A quarter circle to the left of radius 0.5 m about (0, 0.5).
  for (const Pose2& pose : sampleStep({}, {0.5, 0.5, M_PI / 2}, 0.02)) {
    EXPECT_NEAR(std::hypot(pose.x_m, pose.y_m - 0.5), 0.5, 1e-9);
    EXPECT_NEAR(pose.yaw_rad, std::atan2(pose.x_m, 0.5 - pose.y_m), 1e-9);
  }
}

TEST(Path, AddsTheOrientationErrorEvenly) {
  const auto poses = sampleStep({}, {-0.4, 0.0, 0.2}, 0.1);
  ASSERT_EQ(poses.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(poses[i].x_m, -0.1 * static_cast<double>(i + 1), 1e-9);
    EXPECT_NEAR(poses[i].yaw_rad, 0.05 * static_cast<double>(i + 1), 1e-9);
  }
}

TEST(Path, DrawsASidestepStraight) {
  for (const Pose2& pose : sampleStep({}, {0.0, 0.2, 0.0}, 0.02)) {
    EXPECT_NEAR(pose.x_m, 0.0, 1e-12);
    EXPECT_NEAR(pose.yaw_rad, 0.0, 1e-12);
  }
}

TEST(Path, ShowsATurnInPlace) {
  const auto poses = sampleStep({}, {0.0, 0.0, M_PI / 2}, 0.02);
  EXPECT_EQ(poses.size(), 9u);  // 90 degrees in steps of 10
  EXPECT_NEAR(poses[4].yaw_rad, M_PI / 2 * 5 / 9, 1e-9);
}

TEST(Path, WithoutStepsIsTheStart) { EXPECT_EQ(samplePath({}, {}, 0.02).size(), 1u); }

}  // namespace
}  // namespace hexapod
