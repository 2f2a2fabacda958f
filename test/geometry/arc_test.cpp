#include "geometry/arc.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hexapod {
namespace {

TEST(Arc, QuarterCircleToTheLeftByHand) {
  // Radius 1, centre (0, 1): a quarter turn ends at (1, 1), heading 90 degrees, length pi/2.
  const Arc arc = arcThrough(1.0, 1.0);
  EXPECT_NEAR(arc.curvature_per_m, 1.0, 1e-12);
  EXPECT_NEAR(arc.heading_rad, M_PI / 2, 1e-12);
  EXPECT_NEAR(arc.length_m, M_PI / 2, 1e-12);
}

TEST(Arc, EndsInItsPointForwardAndBackward) {
  for (double x : {-0.7, -0.3, -1e-3, 0.2, 0.8}) {
    for (double y : {-0.5, -1e-7, 0.0, 1e-3, 0.4}) {
      const Arc arc = arcThrough(x, y);
      const Pose2 end = arc.at(1.0);
      EXPECT_NEAR(end.x_m, x, 1e-9) << x << " " << y;
      EXPECT_NEAR(end.y_m, y, 1e-9) << x << " " << y;
      EXPECT_NEAR(wrapAngle(end.yaw_rad - 2.0 * std::atan2(y, x)), 0.0, 1e-9) << x << " " << y;
      EXPECT_EQ(arc.length_m < 0.0, x < 0.0);
      EXPECT_NEAR(orientationError(end), 0.0, 1e-9);
    }
  }
}

TEST(Arc, BackwardMirrorsForward) {
  const Arc forward = arcThrough(0.3, 0.1);
  const Arc backward = arcThrough(-0.3, 0.1);
  EXPECT_NEAR(backward.curvature_per_m, forward.curvature_per_m, 1e-12);
  EXPECT_NEAR(backward.heading_rad, -forward.heading_rad, 1e-12);
  EXPECT_NEAR(backward.length_m, -forward.length_m, 1e-12);
}

TEST(Arc, OriginHasNone) {
  const Arc arc = arcThrough(0.0, 0.0);
  EXPECT_EQ(arc.curvature_per_m, 0.0);
  EXPECT_EQ(arc.length_m, 0.0);
  EXPECT_NEAR(orientationError({0.0, 0.0, -0.4}), 0.4, 1e-12);
}

TEST(OrientationError, IsTheAngleBetweenHeadingAndTangent) {
  EXPECT_NEAR(orientationError({1.0, 0.0, 0.1}), 0.1, 1e-12);
  EXPECT_NEAR(orientationError({-1.0, 0.0, -0.1}), 0.1, 1e-12);
  EXPECT_NEAR(orientationError({1.0, 1.0, -M_PI / 2}), M_PI, 1e-12);
}

}  // namespace
}  // namespace hexapod
