#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/pose_metric.h"

namespace hexapod {

/// A pose in the plane that can be looked up by where it is.
struct IndexedPoint {
  Pose2 pose;
  std::int64_t id = 0;   ///< breaks ties between equal distances: the lower one is nearer
  std::size_t slot = 0;  ///< whatever the owner wants to find again
};

/// One answer of a query.
struct Neighbour {
  double squared_distance_m2 = 0.0;
  std::int64_t id = 0;
  std::size_t slot = 0;

  bool operator<(const Neighbour& other) const {
    if (squared_distance_m2 != other.squared_distance_m2) {
      return squared_distance_m2 < other.squared_distance_m2;
    }
    return id < other.id;
  }
};

/// Exact nearest neighbours by a metric: a uniform grid of kCellSize over the square of
/// +-kHalfWidth around the origin. Points beyond the square are kept in its border cells: still
/// exact, only slower. So it is where headings count, which bring no point nearer than its position
/// is.
///
/// Answers depend on the set of points alone, never on the order in which they came.
/// Poses must be finite. Const functions may be called from any thread.
class PointIndex {
 public:
  explicit PointIndex(const PoseMetric& metric = {});

  const PoseMetric& metric() const { return metric_; }

  void insert(const IndexedPoint& point);
  /// Removes the point with this id at this pose; the point must be there.
  void erase(const IndexedPoint& point);
  std::size_t size() const { return size_; }

  /// The `count` nearest points, or all when there are fewer, by distance and then by id.
  std::vector<Neighbour> nearest(const Pose2& pose, std::size_t count) const;

 private:
  static constexpr double kHalfWidth = 1.5;        // [m] more than the robot walks in one behaviour
  static constexpr double kCellSize = 1.0 / 32.0;  // [m] some points per cell in a full repertoire
  static constexpr int kCells = 96;                // along each axis: 2 * kHalfWidth / kCellSize

  struct Query {
    Pose2 pose;
    std::size_t count;
    std::vector<Neighbour> best;  // sorted, at most `count`
  };

  static int cellAlong(double coordinate_m);
  const std::vector<IndexedPoint>& cell(int column, int row) const;
  std::vector<IndexedPoint>& cellOf(const IndexedPoint& point);
  void scanCell(int column, int row, Query& query) const;
  void scanRing(int column, int row, int ring, Query& query) const;

  PoseMetric metric_;
  std::vector<std::vector<IndexedPoint>> cells_;
  std::size_t size_ = 0;
};

}  // namespace hexapod
