#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "planning/obstacles.h"

namespace hexapod {

/// A map of cells of 5 cm, `size_m` wide and high around the origin, whose centres are occupied
/// where the function says so.
inline OccupancyMap mapOf(const std::function<bool(double x_m, double y_m)>& occupied,
                          double size_m = 8.0, double resolution_m = 0.05) {
  OccupancyMap map;
  map.resolution_m = resolution_m;
  map.world_from_map = {-0.5 * size_m, -0.5 * size_m, 0.0};
  map.columns = map.rows = static_cast<int>(std::lround(size_m / resolution_m));
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      const double x_m = (column + 0.5) * resolution_m - 0.5 * size_m;
      const double y_m = (row + 0.5) * resolution_m - 0.5 * size_m;
      map.cells.push_back(occupied(x_m, y_m) ? 100 : 0);
    }
  }
  return map;
}

/// A map of one passage along x, so many cells wide, between walls of one cell. Its corner is the
/// origin.
inline OccupancyMap passageOf(int free, int columns, double resolution_m) {
  OccupancyMap map;
  map.resolution_m = resolution_m;
  map.columns = columns;
  map.rows = free + 2;
  map.cells.assign(static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows), 0);
  std::fill_n(map.cells.begin(), map.columns, 100);
  std::fill_n(map.cells.end() - map.columns, map.columns, 100);
  return map;
}

/// The map of mapOf() for a robot that is a disc of 0.3 m, with a margin of 3 cm.
inline std::shared_ptr<const Obstacles> obstaclesOf(
    const std::function<bool(double x_m, double y_m)>& occupied) {
  return std::make_shared<const Obstacles>(mapOf(occupied), Footprint{{{0.0, 0.0, 0.3}}},
                                           ObstacleOptions{});
}

}  // namespace hexapod
