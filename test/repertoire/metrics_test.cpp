#include "repertoire/metrics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fixtures.h"
#include "geometry/arc.h"

namespace hexapod {
namespace {

constexpr double kPi = 3.14159265358979323846;

Ending endingAt(double x_m, double y_m, double error_rad = 0.0) {
  return {{x_m, y_m, 0.0}, error_rad};
}

TEST(RegionOfInterest, HasTheAreaOfThePaper) {
  const double area_m2 = static_cast<double>(RegionOfInterest().grid().size()) * 0.01 * 0.01;
  EXPECT_NEAR(area_m2, 0.669, 0.003);
}

TEST(RegionOfInterest, EndsAtSixtyDegreesAndBeforeSixtyCentimetresOfArc) {
  const RegionOfInterest region;
  EXPECT_TRUE(region.contains(0.0, 0.0));
  EXPECT_TRUE(region.contains(0.599, 0.0));
  EXPECT_FALSE(region.contains(0.601, 0.0));
  EXPECT_TRUE(region.contains(-0.599, 0.0));
  EXPECT_TRUE(region.contains(0.2 * std::cos(59.9 * kPi / 180), 0.2 * std::sin(59.9 * kPi / 180)));
  EXPECT_FALSE(region.contains(0.2 * std::cos(60.1 * kPi / 180), 0.2 * std::sin(60.1 * kPi / 180)));
  // A quarter circle ends at 45 degrees: its length is chord * (pi / 2) / sqrt(2).
  const double limit_m = 0.6 / (kPi / 2.0) * std::sqrt(2.0);
  const double inside = 0.999 * limit_m / std::sqrt(2.0);
  const double outside = 1.001 * limit_m / std::sqrt(2.0);
  EXPECT_TRUE(region.contains(-inside, inside));
  EXPECT_FALSE(region.contains(-outside, outside));
}

TEST(RegionOfInterest, IsTheSameOnAllFourSides) {
  const RegionOfInterest region;
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const double x_m = random.uniform(-0.8, 0.8);
    const double y_m = random.uniform(-0.8, 0.8);
    EXPECT_EQ(region.contains(x_m, y_m), region.contains(-x_m, y_m));
    EXPECT_EQ(region.contains(x_m, y_m), region.contains(x_m, -y_m));
  }
}

TEST(Metrics, SparsenessIsTheMedianOfTheNearestDistancesByBruteForce) {
  Random random(6);
  const auto endings = learnedEndings(randomEntries(150, random));
  std::vector<double> distances;
  for (const Pose2& point : RegionOfInterest().grid()) {
    double nearest_m = 1e9;
    for (const Ending& ending : endings) {
      nearest_m = std::min(nearest_m, distance(point, ending.pose));
    }
    distances.push_back(nearest_m);
  }
  std::sort(distances.begin(), distances.end());
  const std::size_t n = distances.size();
  const double expected =
      n % 2 == 1 ? distances[n / 2] : 0.5 * (distances[n / 2 - 1] + distances[n / 2]);
  EXPECT_DOUBLE_EQ(measure(endings).sparseness_m, expected);
}

TEST(Metrics, MoreEndingsNeverMakeARepertoireSparser) {
  Random random(7);
  const auto all = learnedEndings(randomEntries(300, random));
  double previous_m = 1e9;
  for (const std::ptrdiff_t count : {1, 10, 100, 300}) {
    const double sparseness_m = measure({all.begin(), all.begin() + count}).sparseness_m;
    EXPECT_LE(sparseness_m, previous_m);
    previous_m = sparseness_m;
  }
}

TEST(Metrics, TellsTheRegionFromTheRest) {
  const auto metrics =
      measure({endingAt(0.1, 0.0, 0.1), endingAt(0.2, 0.0, 0.2), endingAt(-0.3, 0.0, 0.6),
               endingAt(0.0, 0.4, 3.0), endingAt(3.0, 4.0, 2.0)});
  EXPECT_EQ(metrics.endings, 5U);
  EXPECT_EQ(metrics.endings_in_region, 3U);
  EXPECT_DOUBLE_EQ(metrics.median_error_in_region_rad, 0.2);
  EXPECT_DOUBLE_EQ(metrics.median_error_of_all_rad, 0.6);
  EXPECT_DOUBLE_EQ(metrics.max_reach_m, 5.0);
  EXPECT_NEAR(metrics.density_in_region_per_dm2, 3.0 / 66.9, 1e-3);
}

TEST(Metrics, AreZeroWithoutEndings) {
  const auto metrics = measure({});
  EXPECT_EQ(metrics.endings, 0U);
  EXPECT_EQ(metrics.sparseness_m, 0.0);
  EXPECT_EQ(metrics.median_error_in_region_rad, 0.0);
  EXPECT_EQ(metrics.density_in_region_per_dm2, 0.0);
}

TEST(Metrics, MedianIsTheMiddleValueOrTheMeanOfTheMiddleTwo) {
  EXPECT_FALSE(median({}));
  EXPECT_DOUBLE_EQ(*median({3.0}), 3.0);
  EXPECT_DOUBLE_EQ(*median({5.0, 1.0, 3.0}), 3.0);
  EXPECT_DOUBLE_EQ(*median({4.0, 1.0, 2.0, 8.0}), 3.0);
}

TEST(Metrics, ExpectedEndingsAreTheExecutedOnesAndLeaveOutWhatFell) {
  Entry learned;
  learned.end_pose = {0.3, 0.0, 0.25};
  learned.cost = 1.5;
  Entry executed = learned;
  executed.execution = Execution{{0.2, 0.2, 0.0}, 0.01, 0.02, 8, 0};
  Entry fallen = learned;
  fallen.execution = Execution{{0.2, 0.2, 0.0}, 0.01, 0.02, 8, 1};
  EXPECT_EQ(learnedEndings({learned, executed, fallen}).size(), 3U);
  const auto endings = expectedEndings({learned, executed, fallen});
  ASSERT_EQ(endings.size(), 2U);
  EXPECT_DOUBLE_EQ(endings[0].orientation_error_rad, 0.25);
  // The arc through (0.2, 0.2) arrives at 2 * 45 degrees; the robot at 0.
  EXPECT_DOUBLE_EQ(endings[1].orientation_error_rad, kPi / 2.0);
  EXPECT_DOUBLE_EQ(endings[1].pose.x_m, 0.2);
}

}  // namespace
}  // namespace hexapod
