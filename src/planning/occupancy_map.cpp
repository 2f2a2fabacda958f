#include "planning/occupancy_map.h"

#include <cmath>

namespace hexapod {

std::string problemOf(const OccupancyMap& map) {
  const std::string size = std::to_string(map.columns) + " x " + std::to_string(map.rows);
  if (map.columns < 1 || map.rows < 1) {
    return "The map has " + size + " cells: at least one is needed.";
  }
  const auto expected = static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows);
  if (map.cells.size() != expected) {
    return "The map of " + size + " cells comes with " + std::to_string(map.cells.size()) +
           " values instead of " + std::to_string(expected) + ".";
  }
  if (!std::isfinite(map.resolution_m) || map.resolution_m <= 0.0) {
    return "The resolution of the map must be a positive number of metres, not " +
           std::to_string(map.resolution_m) + ".";
  }
  if (!isFinite(map.world_from_map)) return "The origin of the map is not finite.";
  return "";
}

}  // namespace hexapod
