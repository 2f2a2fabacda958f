#include "evolution/k_means.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "repertoire/metrics.h"

namespace hexapod {
namespace {

double distance(const Pose2& point, const Target& target) {
  return std::hypot(point.x_m - target.x_m, point.y_m - target.y_m);
}

std::size_t nearestByHand(const Pose2& point, const std::vector<Target>& targets) {
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < targets.size(); ++k) {
    if (distance(point, targets[k]) < distance(point, targets[nearest])) nearest = k;
  }
  return nearest;
}

TEST(KMeans, FindsTheMiddlesOfTwoClouds) {
  std::vector<Pose2> points;
  for (const double x : {0.0, 10.0}) {
    for (const double dx : {-1.0, 0.0, 1.0}) {
      for (const double y : {-1.0, 1.0}) points.push_back({x + dx, y, 0.3});
    }
  }
  std::vector<Target> targets = kMeans(points, 2, Random(1));
  if (targets[0].x_m > targets[1].x_m) std::swap(targets[0], targets[1]);
  EXPECT_NEAR(targets[0].x_m, 0.0, 1e-12);
  EXPECT_NEAR(targets[1].x_m, 10.0, 1e-12);
  EXPECT_NEAR(targets[0].y_m, 0.0, 1e-12);
}

TEST(KMeans, EndsWhereEveryTargetIsTheMeanOfItsPoints) {
  const std::vector<Pose2> grid = RegionOfInterest().grid();
  const std::vector<Target> targets = kMeans(grid, 20, Random(3));
  std::vector<Target> sums(targets.size());
  std::vector<double> counts(targets.size(), 0.0);
  for (const Pose2& point : grid) {
    const std::size_t owner = nearestByHand(point, targets);
    sums[owner].x_m += point.x_m;
    sums[owner].y_m += point.y_m;
    counts[owner] += 1.0;
  }
  for (std::size_t k = 0; k < targets.size(); ++k) {
    EXPECT_NEAR(targets[k].x_m, sums[k].x_m / counts[k], 1e-9);
    EXPECT_NEAR(targets[k].y_m, sums[k].y_m / counts[k], 1e-9);
  }
}

TEST(KMeans, GivesTheSameTargetsForTheSameSeed) {
  const std::vector<Pose2> grid = RegionOfInterest().grid();
  const std::vector<Target> once = kMeans(grid, 10, Random(5));
  const std::vector<Target> again = kMeans(grid, 10, Random(5));
  for (std::size_t k = 0; k < once.size(); ++k) EXPECT_EQ(once[k].x_m, again[k].x_m);
}

TEST(KMeans, RefusesMoreTargetsThanPoints) {
  EXPECT_THROW(kMeans({{0.0, 0.0, 0.0}}, 2, Random(1)), std::invalid_argument);
  EXPECT_THROW(kMeans({{0.0, 0.0, 0.0}}, 0, Random(1)), std::invalid_argument);
}

TEST(KMeans, SparsenessIsTheMedianDistanceToTheNearestTarget) {
  const std::vector<Pose2> points = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}};
  EXPECT_DOUBLE_EQ(sparsenessOf(points, {{0.0, 0.0}}), 1.0);  // of 0, 1, 2
  EXPECT_EQ(sparsenessOf(points, {}), 0.0);
}

// 100 cells of 66.9 cm^2: a hexagon of that area has half of it within sqrt(33.4 / pi) = 3.26 cm.
TEST(KMeans, SpreadsTheTargetsOfTheControlExperimentsEvenly) {
  const std::vector<Pose2> grid = RegionOfInterest().grid();
  const double sparseness_m = sparsenessOf(grid, kMeans(grid, 100, Random(1)));
  EXPECT_GT(sparseness_m, 0.031);
  EXPECT_LT(sparseness_m, 0.034);
}

}  // namespace
}  // namespace hexapod
