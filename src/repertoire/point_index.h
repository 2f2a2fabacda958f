#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hexapod {

/// A point of the plane that can be looked up by position.
struct IndexedPoint {
  double x_m = 0.0;
  double y_m = 0.0;
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

/// Exact nearest neighbours in the plane: a uniform grid of kCellSize over the square of
/// +-kHalfWidth around the origin. Points beyond the square are kept in its border cells: still
/// exact, only slower.
///
/// Answers depend on the set of points alone, never on the order in which they came.
/// Positions must be finite. Const functions may be called from any thread.
class PointIndex {
 public:
  PointIndex();

  void insert(const IndexedPoint& point);
  /// Removes the point with this id at this position; the point must be there.
  void erase(const IndexedPoint& point);
  std::size_t size() const { return size_; }

  /// The `count` nearest points, or all when there are fewer, by distance and then by id.
  std::vector<Neighbour> nearest(double x_m, double y_m, std::size_t count) const;

 private:
  static constexpr double kHalfWidth = 1.5;        // [m] more than the robot walks in one behaviour
  static constexpr double kCellSize = 1.0 / 32.0;  // [m] some points per cell in a full repertoire
  static constexpr int kCells = 96;                // along each axis: 2 * kHalfWidth / kCellSize

  struct Query {
    double x_m, y_m;
    std::size_t count;
    std::vector<Neighbour> best;  // sorted, at most `count`
  };

  static int cellAlong(double coordinate_m);
  const std::vector<IndexedPoint>& cell(int column, int row) const;
  std::vector<IndexedPoint>& cellOf(const IndexedPoint& point);
  void scanCell(int column, int row, Query& query) const;
  void scanRing(int column, int row, int ring, Query& query) const;

  std::vector<std::vector<IndexedPoint>> cells_;
  std::size_t size_ = 0;
};

}  // namespace hexapod
