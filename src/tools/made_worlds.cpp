#include "tools/made_worlds.h"

#include <algorithm>
#include <cmath>

namespace hexapod {
namespace {

constexpr int kCells = 160;
constexpr double kCell_m = 0.05;
constexpr int kDoor = 18;      // 0.9 m
constexpr int kCorridor = 20;  // 1.0 m
constexpr int kWall = 2;       // 0.1 m
constexpr int kRooms = 3;      // per side
constexpr std::int8_t kOccupied = 100;

void fill(OccupancyMap& map, int column, int row, int columns, int rows, std::int8_t value) {
  for (int r = std::max(0, row); r < std::min(map.rows, row + rows); ++r) {
    for (int c = std::max(0, column); c < std::min(map.columns, column + columns); ++c) {
      map.cells[static_cast<std::size_t>(r * map.columns + c)] = value;
    }
  }
}

int below(Random& random, int count) {
  return static_cast<int>(random.below(static_cast<std::uint64_t>(count)));
}

OccupancyMap walledIn() {
  OccupancyMap map;
  map.resolution_m = kCell_m;
  map.columns = map.rows = kCells;
  map.world_from_map = {-0.5 * kCells * kCell_m, -0.5 * kCells * kCell_m, 0.0};
  map.cells.assign(kCells * kCells, kOccupied);
  fill(map, kWall, kWall, kCells - 2 * kWall, kCells - 2 * kWall, 0);
  return map;
}

/// Walls between rooms side by side; a door in each but `closed` of them.
void addRooms(OccupancyMap& map, bool closed, Random& random) {
  const int pitch = kCells / kRooms;
  for (int i = 1; i < kRooms; ++i) {
    fill(map, i * pitch, 0, kWall, kCells, kOccupied);
    fill(map, 0, i * pitch, kCells, kWall, kOccupied);
  }
  for (int i = 1; i < kRooms; ++i) {
    for (int j = 0; j < kRooms; ++j) {
      if (closed && i == 1) continue;
      const int along = j * pitch + 2 * kWall;
      const int room = pitch - kDoor - 3 * kWall;
      fill(map, i * pitch, along + below(random, room), kWall, kDoor, 0);
      fill(map, along + below(random, room), i * pitch, kDoor, kWall, 0);
    }
  }
}

void addClutter(OccupancyMap& map, int boxes, Random& random) {
  for (int i = 0; i < boxes; ++i) {
    const int width = 4 + below(random, 13);
    const int height = 4 + below(random, 13);
    fill(map, below(random, kCells), below(random, kCells), width, height, kOccupied);
  }
}

/// A tree of corridors, dug at random from one cell on.
void digMaze(OccupancyMap& map, Random& random) {
  constexpr int kPitch = kCorridor + kWall;
  constexpr int kSide = (kCells - kWall) / kPitch;
  const auto start = [](int index) { return kWall + index * kPitch; };
  map.cells.assign(map.cells.size(), kOccupied);
  std::vector<char> seen(kSide * kSide, 0);
  std::vector<int> stack = {below(random, kSide * kSide)};
  seen[static_cast<std::size_t>(stack[0])] = 1;
  fill(map, start(stack[0] % kSide), start(stack[0] / kSide), kCorridor, kCorridor, 0);
  while (!stack.empty()) {
    const int x = stack.back() % kSide;
    const int y = stack.back() / kSide;
    std::vector<int> next;
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      if (x + dx < 0 || y + dy < 0 || x + dx >= kSide || y + dy >= kSide) continue;
      const int cell = (y + dy) * kSide + x + dx;
      if (!seen[static_cast<std::size_t>(cell)]) next.push_back(cell);
    }
    if (next.empty()) {
      stack.pop_back();
      continue;
    }
    const int cell = next[random.below(next.size())];
    const int to_x = cell % kSide;
    const int to_y = cell / kSide;
    fill(map, start(std::min(x, to_x)), start(std::min(y, to_y)),
         kCorridor + kPitch * std::abs(x - to_x), kCorridor + kPitch * std::abs(y - to_y), 0);
    seen[static_cast<std::size_t>(cell)] = 1;
    stack.push_back(cell);
  }
}

}  // namespace

std::vector<WorldKind> openWorldKinds() {
  using Layout = WorldKind::Layout;
  return {{"rooms, doors 0.9 m", Layout::kRooms, 0},
          {"clutter, 15 boxes", Layout::kClutter, 15},
          {"clutter, 25 boxes", Layout::kClutter, 25},
          {"clutter, 35 boxes", Layout::kClutter, 35},
          {"maze, corridors 1.0 m", Layout::kMaze, 0}};
}

WorldKind closedWorldKind() { return {"rooms without a way", WorldKind::Layout::kClosedRooms, 0}; }

OccupancyMap makeWorldOf(const WorldKind& kind, std::uint64_t seed) {
  Random random(seed);
  OccupancyMap map = walledIn();
  switch (kind.layout) {
    case WorldKind::Layout::kRooms:
      addRooms(map, false, random);
      break;
    case WorldKind::Layout::kClosedRooms:
      addRooms(map, true, random);
      break;
    case WorldKind::Layout::kClutter:
      addClutter(map, kind.boxes, random);
      break;
    case WorldKind::Layout::kMaze:
      digMaze(map, random);
      break;
  }
  return map;
}

std::vector<char> connectedCells(const OccupancyMap& map, double radius_m, int column, int row) {
  const double reach = radius_m / map.resolution_m;
  const auto around = static_cast<int>(std::ceil(reach)) + 1;
  const auto isFree = [&](int at_column, int at_row) {
    for (int r = at_row - around; r <= at_row + around; ++r) {
      for (int c = at_column - around; c <= at_column + around; ++c) {
        const bool inside = r >= 0 && c >= 0 && r < map.rows && c < map.columns;
        if (inside && map.at(c, r) < OccupancyMap::kOccupied) continue;
        // From the middle of the one cell to the nearest point of the other.
        const double dx = std::max(0.0, std::abs(c - at_column) - 0.5);
        const double dy = std::max(0.0, std::abs(r - at_row) - 0.5);
        if (std::hypot(dx, dy) < reach) return false;
      }
    }
    return true;
  };
  std::vector<char> connected(map.cells.size(), 0);
  std::vector<char> seen(map.cells.size(), 0);
  std::vector<std::pair<int, int>> open = {{column, row}};
  while (!open.empty()) {
    const auto [c, r] = open.back();
    open.pop_back();
    if (c < 0 || r < 0 || c >= map.columns || r >= map.rows) continue;
    const auto index = static_cast<std::size_t>(r * map.columns + c);
    if (seen[index]) continue;
    seen[index] = 1;
    if (!isFree(c, r)) continue;
    connected[index] = 1;
    open.insert(open.end(), {{c + 1, r}, {c - 1, r}, {c, r + 1}, {c, r - 1}});
  }
  return connected;
}

}  // namespace hexapod
