#pragma once

#include <vector>

#include "planning/occupancy_map.h"

namespace hexapod {

/// Distance from any point to the nearest occupied cell.
///
/// Exact at points of a grid, the corners of the cells among them and, of maps up to some
/// 1,000 x 1,000 cells, the middles of their sides (Felzenszwalb and Huttenlocher 2012: the nearest
/// point of an occupied cell to one of them is one of them); between them bounded by the four
/// around: from above, as a distance cannot change faster than the point moves, from below, as its
/// square bends no more than that of the position. Beyond the map is what unknown cells are.
/// Positions in the frame of the map [m]. Immutable.
class DistanceField {
 public:
  DistanceField(const OccupancyMap& map, bool unknown_is_free);

  /// The distance is at least this [m]: 0 within an occupied cell, kFar when nothing is occupied.
  /// Less than the distance by less than the spacing of the points; where only one straight wall or
  /// one corner is near by a small part of it, in the middle between two by up to half.
  double atLeast(double x_m, double y_m) const;
  /// The distance is at most this [m].
  double atMost(double x_m, double y_m) const;

  static constexpr double kFar_m = 1e6;

 private:
  struct Place {
    std::size_t corner;  ///< lower left
    double x, y;         ///< in the square between four points, 0 .. 1
    double outside;      ///< distance from the map [spacings]
  };

  Place placeOf(double x_m, double y_m) const;
  void markOccupied(const OccupancyMap& map, bool unknown_is_free);
  void spreadAlongColumns();
  void spreadAlongRows();

  std::size_t per_cell_;  ///< points per side of a cell
  double spacing_m_;
  std::size_t columns_;  ///< of points
  std::size_t rows_;
  bool outside_is_free_;
  std::vector<float> points_;  ///< distance of each [spacings]
};

}  // namespace hexapod
