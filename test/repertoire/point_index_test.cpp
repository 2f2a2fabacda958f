#include "repertoire/point_index.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/random.h"

namespace hexapod {
namespace {

std::vector<Neighbour> bruteForce(const std::vector<IndexedPoint>& points, double x_m, double y_m,
                                  std::size_t count) {
  std::vector<Neighbour> all;
  for (const IndexedPoint& point : points) {
    const double dx = point.x_m - x_m;
    const double dy = point.y_m - y_m;
    all.push_back({dx * dx + dy * dy, point.id, point.slot});
  }
  std::sort(all.begin(), all.end());
  all.resize(std::min(count, all.size()));
  return all;
}

std::vector<std::int64_t> idsOf(const std::vector<Neighbour>& neighbours) {
  std::vector<std::int64_t> ids;
  for (const Neighbour& neighbour : neighbours) ids.push_back(neighbour.id);
  return ids;
}

/// Points on a coarse lattice, so that ties abound, some far outside of the grid.
std::vector<IndexedPoint> latticePoints(std::size_t count, Random& random) {
  std::vector<IndexedPoint> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double step_m = random.chance(0.05) ? 3.0 : 0.05;
    points.push_back({step_m * (static_cast<double>(random.below(41)) - 20.0),
                      step_m * (static_cast<double>(random.below(41)) - 20.0),
                      static_cast<std::int64_t>(i), i});
  }
  return points;
}

TEST(PointIndex, FindsWhatBruteForceFindsTiesIncluded) {
  Random random(1);
  for (const std::size_t size : {1U, 15U, 16U, 300U, 3000U}) {
    const auto points = latticePoints(size, random);
    PointIndex index;
    for (const auto& point : points) index.insert(point);
    for (int query = 0; query < 200; ++query) {
      const double width_m = query % 10 == 0 ? 80.0 : 1.6;
      const double x_m = 0.025 * std::round(random.uniform(-width_m, width_m) / 0.025);
      const double y_m = 0.025 * std::round(random.uniform(-width_m, width_m) / 0.025);
      const auto count = static_cast<std::size_t>(random.below(20));
      ASSERT_EQ(idsOf(index.nearest(x_m, y_m, count)), idsOf(bruteForce(points, x_m, y_m, count)));
    }
  }
}

TEST(PointIndex, AnswersDoNotDependOnTheOrderOfInsertion) {
  Random random(2);
  auto points = latticePoints(500, random);
  PointIndex forward;
  for (const auto& point : points) forward.insert(point);
  std::reverse(points.begin(), points.end());
  PointIndex backward;
  for (const auto& point : points) backward.insert(point);
  EXPECT_EQ(idsOf(forward.nearest(0.0, 0.0, 100)), idsOf(backward.nearest(0.0, 0.0, 100)));
}

TEST(PointIndex, ForgetsWhatIsErased) {
  Random random(3);
  auto points = latticePoints(400, random);
  PointIndex index;
  for (const auto& point : points) index.insert(point);
  for (int i = 0; i < 300; ++i) {
    const auto victim = static_cast<std::size_t>(random.below(points.size()));
    index.erase(points[victim]);
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(victim));
  }
  EXPECT_EQ(index.size(), 100U);
  EXPECT_EQ(idsOf(index.nearest(0.1, 0.1, 200)), idsOf(bruteForce(points, 0.1, 0.1, 200)));
}

TEST(PointIndex, OfEquallyNearPointsTheLowerIdComesFirst) {
  PointIndex index;
  index.insert({0.3, 0.0, 9, 0});
  index.insert({-0.3, 0.0, 4, 1});
  index.insert({0.0, 0.3, 7, 2});
  EXPECT_EQ(idsOf(index.nearest(0.0, 0.0, 2)), (std::vector<std::int64_t>{4, 7}));
}

TEST(PointIndex, IsEmptyWithoutPoints) { EXPECT_TRUE(PointIndex().nearest(0.0, 0.0, 5).empty()); }

}  // namespace
}  // namespace hexapod
