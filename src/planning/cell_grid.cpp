#include "planning/cell_grid.h"

#include <cmath>

namespace hexapod {

CellGrid::Index CellGrid::indexOf(const Point& point) const {
  const double column = std::floor((point.x_m - west_m) / cell_m);
  const double row = std::floor((point.y_m - south_m) / cell_m);
  if (!(column >= 0.0 && row >= 0.0 && column < columns && row < rows)) return -1;
  return static_cast<Index>(row) * columns + static_cast<Index>(column);
}

CellGrid::Point CellGrid::centreOf(Index cell) const {
  return {west_m + (columnOf(cell) + 0.5) * cell_m, south_m + (rowOf(cell) + 0.5) * cell_m};
}

}  // namespace hexapod
