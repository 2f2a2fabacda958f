#pragma once

#include <string>
#include <vector>

#include "common/random.h"
#include "planning/occupancy_map.h"

namespace hexapod {

/// A kind of world of 8 m x 8 m in cells of 5 cm, walled in, to be drawn again and again.
struct WorldKind {
  enum class Layout { kRooms, kClutter, kMaze, kClosedRooms };
  std::string name;
  Layout layout = Layout::kRooms;
  int boxes = 0;  ///< of clutter
};

/// Rooms with doors of 0.9 m, clutter of 15, 25 and 35 boxes, mazes with corridors of 1.0 m.
std::vector<WorldKind> openWorldKinds();

/// Rooms of which some have no door.
WorldKind closedWorldKind();

/// One of that kind; equal seeds, equal worlds. Its middle is the origin.
OccupancyMap makeWorldOf(const WorldKind& kind, std::uint64_t seed);

/// The cells that a robot's centre can be in and that hang together with the given one, worked out
/// from the occupied cells alone: where none is nearer to the middle of the cell than `radius_m`.
std::vector<char> connectedCells(const OccupancyMap& map, double radius_m, int column, int row);

}  // namespace hexapod
