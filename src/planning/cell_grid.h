#pragma once

#include <algorithm>
#include <cstdint>

namespace hexapod {

/// Square cells in the frame of a map, row by row from the lower left corner on.
struct CellGrid {
  using Index = std::int32_t;

  struct Point {
    double x_m, y_m;
  };

  double cell_m = 0.05;
  double west_m = 0.0;
  double south_m = 0.0;
  Index columns = 0;
  Index rows = 0;

  Index size() const { return columns * rows; }
  Index columnOf(Index cell) const { return cell % columns; }
  Index rowOf(Index cell) const { return cell / columns; }

  /// The cell of a point, -1 outside.
  Index indexOf(const Point& point) const;

  Point centreOf(Index cell) const;

  /// Calls visit(cell, columns_east, rows_north) for the cells up to `reach` columns and rows away
  /// from a place, which may lie outside itself.
  template <typename Visit>
  void around(Index column, Index row, Index reach, const Visit& visit) const {
    for (Index r = std::max(0, row - reach); r <= std::min(rows - 1, row + reach); ++r) {
      for (Index c = std::max(0, column - reach); c <= std::min(columns - 1, column + reach); ++c) {
        visit(r * columns + c, c - column, r - row);
      }
    }
  }
};

}  // namespace hexapod
