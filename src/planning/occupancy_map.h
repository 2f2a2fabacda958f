#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/pose2.h"

namespace hexapod {

/// What a grid of cells says of the floor, as nav_msgs/OccupancyGrid does: row by row from the
/// origin, which is the outer corner of the first cell and may be turned.
struct OccupancyMap {
  static constexpr std::int8_t kUnknown = -1;
  /// Cells from here on are occupied, 0 to here free.
  static constexpr std::int8_t kOccupied = 50;

  Pose2 world_from_map;
  double resolution_m = 0.05;  ///< side of a cell
  int columns = 0;
  int rows = 0;
  std::vector<std::int8_t> cells;  ///< cells[row * columns + column]: kUnknown or 0 .. 100

  std::int8_t at(int column, int row) const {
    return cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                 static_cast<std::size_t>(column)];
  }
};

/// What makes a map unusable, as a sentence, or "" when nothing does: sides, resolution, origin or
/// number of cells.
std::string problemOf(const OccupancyMap& map);

}  // namespace hexapod
