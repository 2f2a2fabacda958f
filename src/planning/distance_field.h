#pragma once

#include <vector>

#include "planning/occupancy_map.h"

namespace hexapod {

/// Distance from any point to the nearest occupied cell.
///
/// Exact at the corners of the cells (Felzenszwalb and Huttenlocher 2012: the nearest point of an
/// occupied cell to a corner is itself a corner); between them bounded by the four corners around,
/// as a distance cannot change faster than the point moves. Beyond the map is what unknown cells
/// are. Points in the frame of the map [m]. Immutable.
class DistanceField {
 public:
  DistanceField(const OccupancyMap& map, bool unknown_is_free);

  /// The distance is at least this [m]: 0 within an occupied cell, kFar when nothing is occupied;
  /// less than the distance by less than a cell, beside a straight wall by a fifth of one.
  double atLeast(double x_m, double y_m) const;
  /// The distance is at most this [m].
  double atMost(double x_m, double y_m) const;

  static constexpr double kFar_m = 1e6;

 private:
  struct Cell {
    std::size_t corner;  ///< lower left
    double x, y;         ///< of the point in the cell, 0 .. 1
    double outside;      ///< distance from the map [cells]
  };

  Cell cellOf(double x_m, double y_m) const;
  void markCorners(const OccupancyMap& map, bool unknown_is_free);
  void spreadAlongColumns();
  void spreadAlongRows();

  double resolution_m_;
  std::size_t columns_;  ///< of corners
  std::size_t rows_;
  bool outside_is_free_;
  std::vector<float> cells_;  ///< distance of each corner [cells]
};

}  // namespace hexapod
