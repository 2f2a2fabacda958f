#include "repertoire/point_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/random.h"

namespace hexapod {
namespace {

/// Every point held against the pose, a turn of the heading worth `heading_m_per_rad` per radian.
std::vector<Neighbour> bruteForce(const std::vector<IndexedPoint>& points, const Pose2& pose,
                                  std::size_t count, double heading_m_per_rad = 0.0) {
  std::vector<Neighbour> all;
  for (const IndexedPoint& point : points) {
    const double dx = point.pose.x_m - pose.x_m;
    const double dy = point.pose.y_m - pose.y_m;
    const double turn_m = heading_m_per_rad * wrapAngle(point.pose.yaw_rad - pose.yaw_rad);
    all.push_back({dx * dx + dy * dy + turn_m * turn_m, point.id, point.slot});
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
    points.push_back(
        {{step_m * (static_cast<double>(random.below(41)) - 20.0),
          step_m * (static_cast<double>(random.below(41)) - 20.0), random.uniform(-M_PI, M_PI)},
         static_cast<std::int64_t>(i),
         i});
  }
  return points;
}

TEST(PointIndex, FindsWhatBruteForceFindsTiesIncluded) {
  Random random(1);
  for (const std::size_t size : {1U, 15U, 16U, 300U, 3000U}) {
    const auto points = latticePoints(size, random);
    PointIndex index, with_headings({0.2});
    for (const auto& point : points) {
      index.insert(point);
      with_headings.insert(point);
    }
    for (int query = 0; query < 200; ++query) {
      const double width_m = query % 10 == 0 ? 80.0 : 1.6;
      const Pose2 pose{0.025 * std::round(random.uniform(-width_m, width_m) / 0.025),
                       0.025 * std::round(random.uniform(-width_m, width_m) / 0.025),
                       random.uniform(-M_PI, M_PI)};
      const auto count = static_cast<std::size_t>(random.below(20));
      ASSERT_EQ(idsOf(index.nearest(pose, count)), idsOf(bruteForce(points, pose, count)));
      ASSERT_EQ(idsOf(with_headings.nearest(pose, count)),
                idsOf(bruteForce(points, pose, count, 0.2)));
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
  EXPECT_EQ(idsOf(forward.nearest({}, 100)), idsOf(backward.nearest({}, 100)));
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
  EXPECT_EQ(idsOf(index.nearest({0.1, 0.1, 0.0}, 200)),
            idsOf(bruteForce(points, {0.1, 0.1, 0.0}, 200)));
}

TEST(PointIndex, OfEquallyNearPointsTheLowerIdComesFirst) {
  PointIndex index;
  index.insert({{0.3, 0.0, 1.0}, 9, 0});
  index.insert({{-0.3, 0.0, -1.0}, 4, 1});
  index.insert({{0.0, 0.3, 3.0}, 7, 2});
  EXPECT_EQ(idsOf(index.nearest({}, 2)), (std::vector<std::int64_t>{4, 7}));
}

TEST(PointIndex, CountsHeadingsTheShorterWayRound) {
  PointIndex index({0.1});
  index.insert({{0.0, 0.0, M_PI - 0.1}, 1, 0});
  index.insert({{0.0, 0.0, 0.0}, 2, 1});
  const auto nearest = index.nearest({0.0, 0.04, 0.1 - M_PI}, 2);
  EXPECT_EQ(idsOf(nearest), (std::vector<std::int64_t>{1, 2}));
  // 4 cm aside and 0.2 rad across the seam, at 0.1 m each.
  EXPECT_NEAR(nearest[0].squared_distance_m2, 0.04 * 0.04 + 0.02 * 0.02, 1e-12);
}

TEST(PointIndex, IsEmptyWithoutPoints) { EXPECT_TRUE(PointIndex().nearest({}, 5).empty()); }

}  // namespace
}  // namespace hexapod
