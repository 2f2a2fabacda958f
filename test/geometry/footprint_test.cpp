#include "geometry/footprint.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/random.h"

namespace hexapod {
namespace {

bool covers(const Footprint& footprint, double x_m, double y_m) {
  for (const Disc& disc : footprint.discs) {
    if (std::hypot(x_m - disc.x_m, y_m - disc.y_m) <= disc.radius_m + 1e-9) return true;
  }
  return false;
}

std::vector<Eigen::Vector2d> rectangle(double length_m, double width_m) {
  return {{0.5 * length_m, 0.5 * width_m},
          {-0.5 * length_m, 0.5 * width_m},
          {-0.5 * length_m, -0.5 * width_m},
          {0.5 * length_m, -0.5 * width_m}};
}

TEST(ConvexHull, KeepsTheCornersOfASquareOnly) {
  std::vector<Eigen::Vector2d> points = rectangle(2.0, 2.0);
  points.insert(points.end(), {{0.0, 0.0}, {1.0, 0.0}, {0.3, -0.7}, {1.0, 1.0}});
  EXPECT_EQ(convexHull(points).size(), 4u);
}

TEST(Footprint, CoversAllBetweenThePoints) {
  for (const double length_m : {0.3, 0.6, 1.0, 3.0}) {
    const Footprint footprint = coverWithDiscs(rectangle(length_m, 0.3));
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
      EXPECT_TRUE(
          covers(footprint, length_m * random.uniform(-0.5, 0.5), 0.3 * random.uniform(-0.5, 0.5)));
    }
  }
}

TEST(Footprint, IsOneDiscOfARobotAboutAsLongAsWideAndSeveralOfALongOne) {
  EXPECT_EQ(coverWithDiscs(rectangle(0.4, 0.3)).discs.size(), 1u);
  const Footprint longer = coverWithDiscs(rectangle(0.8, 0.3));
  EXPECT_EQ(longer.discs.size(), 2u);
  // Two strips of 0.4 m by 0.3 m: discs of half their diagonal, 0.2 m from the middle.
  EXPECT_NEAR(longer.outer_m(), 0.2 + 0.25, 1e-9);
  EXPECT_NEAR(longer.inner_m(), 0.25 - 0.2, 1e-9);
  EXPECT_NEAR(longer.offset_m(), 0.2, 1e-9);
  EXPECT_NEAR(longer.grownBy(0.03).inner_m(), 0.08, 1e-9);
}

TEST(Footprint, OfNoPointsIsEmpty) { EXPECT_TRUE(coverWithDiscs({}).discs.empty()); }

}  // namespace
}  // namespace hexapod
