#include "robot_import/fit_shape.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hexapod {
namespace {

Points boxCorners(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  Points points;
  for (int corner = 0; corner < 8; ++corner) {
    points.emplace_back(corner & 1 ? high.x() : low.x(), corner & 2 ? high.y() : low.y(),
                        corner & 4 ? high.z() : low.z());
  }
  return points;
}

TEST(FitShape, CapsuleIsAsLongAsThePointsAndAsThickAsTheyAreOnTheMean) {
  const Shape shape = fitCapsule(boxCorners({0.0, -0.01, -0.02}, {0.2, 0.01, 0.02}));
  ASSERT_EQ(shape.kind, Shape::Kind::kCapsule);
  // Across 0.02 by 0.04 m: diameter sqrt(0.02 * 0.04).
  EXPECT_NEAR(shape.radius_m, 0.5 * std::sqrt(0.02 * 0.04), 1e-12);
  EXPECT_NEAR(shape.length_m + 2.0 * shape.radius_m, 0.2, 1e-12);
  EXPECT_NEAR(std::abs(shape.body_from_shape.linear()(0, 2)), 1.0, 1e-12);
  EXPECT_TRUE(shape.body_from_shape.translation().isApprox(Eigen::Vector3d(0.1, 0, 0)));
}

TEST(FitShape, CubeBecomesASphere) {
  const Shape shape = fitCapsule(boxCorners({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}));
  EXPECT_EQ(shape.kind, Shape::Kind::kSphere);
  EXPECT_NEAR(shape.radius_m, 0.1, 1e-12);
}

TEST(FitShape, BoxFollowsPointsThatLieAskew) {
  const Eigen::AngleAxisd turn(0.6, Eigen::Vector3d(1, 2, 3).normalized());
  Points points = boxCorners({-0.2, -0.05, -0.01}, {0.2, 0.05, 0.01});
  for (Eigen::Vector3d& point : points) point = turn * point;
  const Shape shape = fitBox(points);
  EXPECT_NEAR(shape.size_m.prod(), 0.4 * 0.1 * 0.02, 1e-9);
}

TEST(FitShape, TipEndsWhereThePointsEnd) {
  const Points points = boxCorners({0.0, -0.01, -0.01}, {0.15, 0.01, 0.01});
  const Shape shape = fitTip(points, Eigen::Vector3d::Zero());
  double end_m = 0.0;
  for (const Eigen::Vector3d& core : corePoints(shape)) {
    end_m = std::max(end_m, core.x() + shape.radius_m);
    EXPECT_NEAR(core.y(), 0.0, 1e-9);
  }
  EXPECT_NEAR(end_m, 0.15, 1e-9);
}

TEST(FitShape, ShapesInsideOthersAreFound) {
  Shape box = fitBox(boxCorners({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}));
  Shape ball;
  ball.radius_m = 0.05;
  EXPECT_TRUE(isInside(ball, box));
  EXPECT_FALSE(isInside(box, ball));
  ball.body_from_shape.translation().x() = 0.08;
  EXPECT_FALSE(isInside(ball, box));
}

TEST(FitShape, GapIsTheDistanceOfTheSurfaces) {
  Shape ball;
  ball.radius_m = 0.02;
  Shape bar = rod({0.0, 0.0, 0.3}, 0.03);
  ball.body_from_shape.translation() << 0.1, 0.0, 0.15;
  EXPECT_NEAR(gap_m(ball, bar), 0.1 - 0.02 - 0.03, 1e-12);
  // Beyond the end: the cap's centre is at 0.27 m.
  ball.body_from_shape.translation() << 0.0, 0.0, 0.4;
  EXPECT_NEAR(gap_m(ball, bar), 0.13 - 0.02 - 0.03, 1e-12);
}

TEST(FitShape, InertiaOfASphereIsTwoFifthsOfItsMassAndRadiusSquared) {
  Shape ball;
  ball.radius_m = 0.1;
  const double expected = 0.4 * volume_m3(ball) * 0.01;
  EXPECT_TRUE(solidInertia(ball).isApprox(expected * Eigen::Matrix3d::Identity()));
}

}  // namespace
}  // namespace hexapod
