#include "planning/way_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hexapod {
namespace {

constexpr double kFinestWayCell_m = 0.05;
constexpr double kMostCells = 4e6;
// Beyond the start a search may still want to turn.
constexpr double kBeyond_m = 2.5;
// Seen between two looks at whether it is to stop: a millisecond.
constexpr std::size_t kCellsAtOnce = 8192;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Steps of 1 and 7/5 overestimate a straight line by at most sqrt(1 + 0.4^2), at a slope of 0.4.
constexpr double kLongest = 1.0771;
// From a point to the centre of its cell, at both ends.
constexpr double kEnds = 2.0 * 1.4;

}  // namespace

WayField::WayField(const Question& question, Open open, double around_m)
    : question_(question), open_(open), most_m_(2.0 * around_m) {
  layOut(around_m);
  start_ = grid_.indexOf(inMap(question.world_from_start.x_m, question.world_from_start.y_m));
  spread();
  question_.stop = nullptr;
}

/// Chooses the rectangle of cells: start, goal and what is around them, within the map or, where
/// beyond it is free, a way around it.
void WayField::layOut(double around_m) {
  const Obstacles& obstacles = *question_.obstacles;
  const Pose2 map_from_world = inverse(obstacles.worldFromMap());
  const Pose2 start = map_from_world * question_.world_from_start;
  const Pose2 goal = map_from_world * question_.world_from_goal;
  const double rim_m = obstacles.options().unknown_is_free ? 2.0 : 0.0;
  const auto span = [&](double a, double b, double size) {
    const double low = std::max(std::min(a, b) - around_m, std::min({0.0, a, b}) - rim_m);
    const double high = std::min(std::max(a, b) + around_m, std::max({size, a, b}) + rim_m);
    return std::make_pair(low, high);
  };
  const auto [west, east] = span(start.x_m, goal.x_m, obstacles.width_m());
  const auto [south, north] = span(start.y_m, goal.y_m, obstacles.height_m());
  const double cell_m =
      std::max(kFinestWayCell_m, std::sqrt((east - west) * (north - south) / kMostCells));
  grid_.cell_m = cell_m;
  // Cells of the map and of the same size lie on each other.
  grid_.west_m = std::floor(west / cell_m) * cell_m;
  grid_.south_m = std::floor(south / cell_m) * cell_m;
  grid_.columns = static_cast<Index>((east - grid_.west_m) / cell_m) + 1;
  grid_.rows = static_cast<Index>((north - grid_.south_m) / cell_m) + 1;
  cells_ = ZeroedArray<Cell>(static_cast<std::size_t>(grid_.size()));
}

WayField::Point WayField::inMap(double world_x_m, double world_y_m) const {
  const Obstacles::Point at = question_.obstacles->mapFromWorld(world_x_m, world_y_m);
  return {at.x_m, at.y_m};
}

bool WayField::isOpen(Index cell) const {
  const Point at = grid_.centreOf(cell);
  if (open_ == Open::kSurely) return question_.obstacles->leastRoom_m({at.x_m, at.y_m}) >= 0.0;
  return question_.obstacles->mostRoom_m({at.x_m, at.y_m}) + 0.7072 * grid_.cell_m >= 0.0;
}

bool WayField::sees(const Point& from, const Point& to) const {
  const double length_m = std::hypot(to.x_m - from.x_m, to.y_m - from.y_m);
  for (double along_m = 0.0; along_m < length_m;) {
    const double share = along_m / length_m;
    const Obstacles::Point at{from.x_m + share * (to.x_m - from.x_m),
                              from.y_m + share * (to.y_m - from.y_m)};
    const double room_m = question_.obstacles->leastRoom_m(at);
    if (room_m < -0.5 * grid_.cell_m) return false;
    along_m += std::max(room_m, 0.5 * grid_.cell_m);
  }
  return true;
}

/// The cells in which a way ends: all that are near enough to the goal, as in a wide tolerance they
/// need not be connected with each other.
std::vector<WayField::Index> WayField::seeds() const {
  const Pose2 goal = inverse(question_.obstacles->worldFromMap()) * question_.world_from_goal;
  const double radius_m = std::max(question_.radius_m, 1.5 * grid_.cell_m);
  const auto column = static_cast<Index>((goal.x_m - grid_.west_m) / grid_.cell_m);
  const auto row = static_cast<Index>((goal.y_m - grid_.south_m) / grid_.cell_m);
  const auto reach = static_cast<Index>(radius_m / grid_.cell_m) + 1;
  std::vector<Index> result;
  grid_.around(column, row, reach, [&](Index cell, Index, Index) {
    const Point centre = grid_.centreOf(cell);
    const double off_m = std::hypot(centre.x_m - goal.x_m, centre.y_m - goal.y_m);
    if (off_m <= radius_m && isOpen(cell)) result.push_back(cell);
  });
  return result;
}

void WayField::spread() {
  constexpr std::size_t kBuckets = 8;  // more than the longest step
  std::array<std::vector<std::pair<Index, Index>>, kBuckets> buckets;
  for (const Index seed : seeds()) buckets[0].push_back({seed, seed});
  std::int32_t last = std::numeric_limits<std::int32_t>::max();
  std::int32_t empty = 0;
  std::size_t seen = 0;
  for (std::int32_t now = 0; now <= last && empty < static_cast<std::int32_t>(kBuckets); ++now) {
    if (seen > kCellsAtOnce) {
      seen = 0;
      cut_short_ = question_.stop && question_.stop();
      if (cut_short_) return;
    }
    std::vector<std::pair<Index, Index>>& bucket =
        buckets[static_cast<std::size_t>(now) % kBuckets];
    empty = bucket.empty() ? empty + 1 : 0;
    seen += bucket.size();
    for (const auto& [cell, predecessor] : bucket) {
      if (!take(cell, predecessor, now)) continue;
      if (!reached_ && isAtStart(cell)) {
        reached_ = true;
        last = now + static_cast<std::int32_t>(5.0 * kBeyond_m / grid_.cell_m);
      }
      const auto goOn = [&, from = cell](Index next, Index east, Index north) {
        if (at(next).isSeen()) return;
        const std::int32_t step = east != 0 && north != 0 ? 7 : 5;
        buckets[static_cast<std::size_t>(now + step) % kBuckets].push_back({next, from});
      };
      grid_.around(grid_.columnOf(cell), grid_.rowOf(cell), 1, goOn);
    }
    bucket.clear();
  }
}

/// Whether the wave goes on from a cell that it has come to.
bool WayField::take(Index cell, Index predecessor, std::int32_t fifths) {
  if (at(cell).isSeen()) return false;
  if (!isOpen(cell)) {
    at(cell).state = Cell::kClosed;
    return false;
  }
  farthest_fifths_ = fifths;
  at(cell).state = fifths + 1;
  straighten(cell, predecessor);
  return true;
}

bool WayField::isAtStart(Index cell) const {
  return start_ >= 0 && std::abs(grid_.columnOf(cell) - grid_.columnOf(start_)) <= 1 &&
         std::abs(grid_.rowOf(cell) - grid_.rowOf(start_)) <= 1;
}

void WayField::straighten(Index cell, Index predecessor) {
  const Point from = grid_.centreOf(cell);
  Index corner = predecessor;
  if (predecessor != cell) {
    const Index before = at(predecessor).corner;
    if (sees(from, grid_.centreOf(before))) corner = before;
  }
  Cell& here = at(cell);
  here.corner = corner;
  const Way way = through(from, corner);
  here.length_m = static_cast<float>(way.length_m);
  here.arrival_rad = static_cast<float>(way.arrival_rad);
}

/// The way from a point of the map straight to a corner and on, or to the goal itself where that
/// corner is one of those around it. Headings in the map.
WayField::Way WayField::through(const Point& from, Index corner) const {
  const Cell& next = at(corner);
  const bool at_goal = next.corner == corner || next.fifths() == 0;
  Point to = grid_.centreOf(corner);
  if (at_goal) {
    const Pose2 goal = inverse(question_.obstacles->worldFromMap()) * question_.world_from_goal;
    to = {goal.x_m, goal.y_m};
  }
  const double direction_rad = std::atan2(to.y_m - from.y_m, to.x_m - from.x_m);
  const double straight_m = std::hypot(to.x_m - from.x_m, to.y_m - from.y_m);
  if (at_goal) return {straight_m, direction_rad, direction_rad};
  return {straight_m + next.length_m, direction_rad, next.arrival_rad};
}

std::optional<WayField::Way> WayField::wayFrom(double world_x_m, double world_y_m) const {
  const Point from = inMap(world_x_m, world_y_m);
  const Index own = grid_.indexOf(from);
  if (own < 0) return std::nullopt;
  Index best = at(own).isReached() ? own : -1;
  if (best < 0) {
    grid_.around(grid_.columnOf(own), grid_.rowOf(own), 1, [&](Index beside, Index, Index) {
      if (!at(beside).isReached()) return;
      if (best < 0 || at(beside).fifths() < at(best).fifths()) best = beside;
    });
  }
  if (best < 0) return std::nullopt;
  Index corner = at(best).corner;
  const Point to = grid_.centreOf(corner);
  if (std::hypot(to.x_m - from.x_m, to.y_m - from.y_m) < 2.0 * grid_.cell_m)
    corner = at(corner).corner;
  Way way = through(from, corner);
  const double turn_rad = question_.obstacles->worldFromMap().yaw_rad;
  way.direction_rad += turn_rad;
  way.arrival_rad += turn_rad;
  return way;
}

double WayField::atLeast_m(double world_x_m, double world_y_m) const {
  const Index cell = grid_.indexOf(inMap(world_x_m, world_y_m));
  const bool is_known = cell >= 0 && at(cell).isReached();
  if (!is_known && !reached_) return kInfinity;
  const std::int32_t fifths = is_known ? at(cell).fifths() : farthest_fifths_;
  return std::clamp((fifths / 5.0 - kEnds) * grid_.cell_m / kLongest, 0.0, most_m_);
}

bool WayField::isAmong(const std::shared_ptr<const Obstacles>& obstacles) const {
  return question_.obstacles == obstacles;
}

bool WayField::answers(const Question& question) const {
  return isAmong(question.obstacles) && question_.radius_m == question.radius_m &&
         distance(question_.world_from_goal, question.world_from_goal) == 0.0 &&
         wayFrom(question.world_from_start.x_m, question.world_from_start.y_m).has_value();
}

std::optional<Pose2> WayField::freePoseNearest(const Pose2& world_from_wish) const {
  const Pose2& world_from_map = question_.obstacles->worldFromMap();
  const Pose2 wish = inverse(world_from_map) * world_from_wish;
  std::optional<Pose2> nearest;
  double least_m = kInfinity;
  for (Index cell = 0; cell < grid_.size(); ++cell) {
    if (!at(cell).isReached()) continue;
    const Point centre = grid_.centreOf(cell);
    const double off_m = std::hypot(centre.x_m - wish.x_m, centre.y_m - wish.y_m);
    if (off_m >= least_m) continue;
    const Pose2 pose = world_from_map * Pose2{centre.x_m, centre.y_m, wish.yaw_rad};
    if (!question_.obstacles->isFree(pose)) continue;
    nearest = pose;
    least_m = off_m;
  }
  return nearest;
}

}  // namespace hexapod
