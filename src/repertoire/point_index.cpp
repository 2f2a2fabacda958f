#include "repertoire/point_index.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

namespace hexapod {

PointIndex::PointIndex(const PoseMetric& metric)
    : metric_(metric), cells_(static_cast<std::size_t>(kCells) * kCells) {}

void PointIndex::insert(const IndexedPoint& point) {
  assert(isFinite(point.pose));
  cellOf(point).push_back(point);
  ++size_;
}

void PointIndex::erase(const IndexedPoint& point) {
  std::vector<IndexedPoint>& points = cellOf(point);
  const auto found = std::find_if(points.begin(), points.end(), [&](const IndexedPoint& candidate) {
    return candidate.id == point.id;
  });
  assert(found != points.end());
  *found = points.back();
  points.pop_back();
  --size_;
}

std::vector<Neighbour> PointIndex::nearest(const Pose2& pose, std::size_t count) const {
  Query query{pose, std::min(count, size_), {}};
  query.best.reserve(query.count);
  const int column = cellAlong(pose.x_m);
  const int row = cellAlong(pose.y_m);
  for (int ring = 0; ring < kCells; ++ring) {
    // Clamping into the square shortens no distance to less than this: cells of the ring are at
    // least ring - 1 cells away. Equal distances are still looked at: the id decides.
    const double reach_m = std::max(0, ring - 1) * kCellSize;
    const bool full = query.best.size() == query.count;
    if (full && (query.count == 0 || reach_m * reach_m > query.best.back().squared_distance_m2)) {
      break;
    }
    scanRing(column, row, ring, query);
  }
  return std::move(query.best);
}

int PointIndex::cellAlong(double coordinate_m) {
  const double clamped_m = std::clamp(coordinate_m, -kHalfWidth, kHalfWidth);
  return std::min(kCells - 1, static_cast<int>((clamped_m + kHalfWidth) / kCellSize));
}

const std::vector<IndexedPoint>& PointIndex::cell(int column, int row) const {
  return cells_[static_cast<std::size_t>(row) * kCells + static_cast<std::size_t>(column)];
}

std::vector<IndexedPoint>& PointIndex::cellOf(const IndexedPoint& point) {
  const auto row = static_cast<std::size_t>(cellAlong(point.pose.y_m));
  return cells_[row * kCells + static_cast<std::size_t>(cellAlong(point.pose.x_m))];
}

void PointIndex::scanCell(int column, int row, Query& query) const {
  for (const IndexedPoint& point : cell(column, row)) {
    const Neighbour candidate{metric_.squaredDistance_m2(point.pose, query.pose), point.id,
                              point.slot};
    if (query.best.size() == query.count) {
      if (!(candidate < query.best.back())) continue;
      query.best.pop_back();
    }
    query.best.insert(std::upper_bound(query.best.begin(), query.best.end(), candidate), candidate);
  }
}

void PointIndex::scanRing(int column, int row, int ring, Query& query) const {
  const int first = std::max(0, row - ring);
  const int last = std::min(kCells - 1, row + ring);
  for (int y = first; y <= last; ++y) {
    // Top and bottom of the ring are whole rows, the rows between have their two ends only.
    const int step = std::abs(y - row) == ring ? 1 : 2 * ring;
    for (int x = column - ring; x <= column + ring; x += step) {
      if (x >= 0 && x < kCells) scanCell(x, y, query);
    }
  }
}

}  // namespace hexapod
