#include "planning/way_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hexapod {
namespace {

constexpr double kFinestCell_m = 0.05;
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
  cell_m_ = std::max(kFinestCell_m, std::sqrt((east - west) * (north - south) / kMostCells));
  // Cells of the map and of the same size lie on each other.
  west_m_ = std::floor(west / cell_m_) * cell_m_;
  south_m_ = std::floor(south / cell_m_) * cell_m_;
  columns_ = static_cast<Index>((east - west_m_) / cell_m_) + 1;
  rows_ = static_cast<Index>((north - south_m_) / cell_m_) + 1;
  cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
}

/// -1 outside.
WayField::Index WayField::indexOf(double world_x_m, double world_y_m) const {
  const Obstacles::Point at = question_.obstacles->mapFromWorld(world_x_m, world_y_m);
  const double column = std::floor((at.x_m - west_m_) / cell_m_);
  const double row = std::floor((at.y_m - south_m_) / cell_m_);
  if (!(column >= 0.0 && row >= 0.0 && column < columns_ && row < rows_)) return -1;
  return static_cast<Index>(row) * columns_ + static_cast<Index>(column);
}

/// In the frame of the map.
WayField::Point WayField::centreOf(Index cell) const {
  const Index row = cell / columns_;
  return {west_m_ + (cell % columns_ + 0.5) * cell_m_, south_m_ + (row + 0.5) * cell_m_};
}

bool WayField::isOpen(Index cell) const {
  const Point at = centreOf(cell);
  if (open_ == Open::kSurely) return question_.obstacles->leastRoom_m({at.x_m, at.y_m}) >= 0.0;
  return question_.obstacles->mostRoom_m({at.x_m, at.y_m}) + 0.7072 * cell_m_ >= 0.0;
}

bool WayField::sees(const Point& from, const Point& to) const {
  const double length_m = std::hypot(to.x_m - from.x_m, to.y_m - from.y_m);
  for (double along_m = 0.0; along_m < length_m;) {
    const double share = along_m / length_m;
    const Obstacles::Point at{from.x_m + share * (to.x_m - from.x_m),
                              from.y_m + share * (to.y_m - from.y_m)};
    const double room_m = question_.obstacles->leastRoom_m(at);
    if (room_m < -0.5 * cell_m_) return false;
    along_m += std::max(room_m, 0.5 * cell_m_);
  }
  return true;
}

/// The cells in which a way ends: all that are near enough to the goal, as in a wide tolerance they
/// need not be connected with each other.
std::vector<WayField::Index> WayField::seeds() const {
  const Pose2 goal = inverse(question_.obstacles->worldFromMap()) * question_.world_from_goal;
  const double radius_m = std::max(question_.radius_m, 1.5 * cell_m_);
  std::vector<Index> result;
  const auto reach = static_cast<Index>(radius_m / cell_m_) + 1;
  const Index column = static_cast<Index>((goal.x_m - west_m_) / cell_m_);
  const Index row = static_cast<Index>((goal.y_m - south_m_) / cell_m_);
  for (Index r = std::max(0, row - reach); r <= std::min(rows_ - 1, row + reach); ++r) {
    for (Index c = std::max(0, column - reach); c <= std::min(columns_ - 1, column + reach); ++c) {
      const Index cell = r * columns_ + c;
      const Point at = centreOf(cell);
      const double off_m = std::hypot(at.x_m - goal.x_m, at.y_m - goal.y_m);
      if (off_m <= radius_m && isOpen(cell)) result.push_back(cell);
    }
  }
  return result;
}

void WayField::spread() {
  constexpr std::size_t kBuckets = 8;  // more than the longest step
  std::array<std::vector<std::pair<Index, Index>>, kBuckets> buckets;
  const Index start = indexOf(question_.world_from_start.x_m, question_.world_from_start.y_m);
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
      if (cells_[static_cast<std::size_t>(cell)].fifths != kUnseen) continue;
      if (!isOpen(cell)) {
        cells_[static_cast<std::size_t>(cell)].fifths = kClosed;
        continue;
      }
      cells_[static_cast<std::size_t>(cell)].fifths = farthest_fifths_ = now;
      straighten(cell, predecessor);
      const Index column = cell % columns_;
      const Index row = cell / columns_;
      if (start >= 0 && !reached_ && std::abs(column - start % columns_) <= 1 &&
          std::abs(row - start / columns_) <= 1) {
        reached_ = true;
        last = now + static_cast<std::int32_t>(5.0 * kBeyond_m / cell_m_);
      }
      for (Index r = std::max(0, row - 1); r <= std::min(rows_ - 1, row + 1); ++r) {
        for (Index c = std::max(0, column - 1); c <= std::min(columns_ - 1, column + 1); ++c) {
          const Index next = r * columns_ + c;
          if (cells_[static_cast<std::size_t>(next)].fifths != kUnseen) continue;
          const std::int32_t step = r != row && c != column ? 7 : 5;
          buckets[static_cast<std::size_t>(now + step) % kBuckets].push_back({next, cell});
        }
      }
    }
    bucket.clear();
  }
}

void WayField::straighten(Index cell, Index predecessor) {
  const Point from = centreOf(cell);
  Index corner = predecessor;
  if (predecessor != cell) {
    const Index before = cells_[static_cast<std::size_t>(predecessor)].corner;
    if (before >= 0 && sees(from, centreOf(before))) corner = before;
  }
  Cell& here = cells_[static_cast<std::size_t>(cell)];
  here.corner = corner;
  const Way way = through(from, corner);
  here.length_m = static_cast<float>(way.length_m);
  here.arrival_rad = static_cast<float>(way.arrival_rad);
}

/// The way from a point of the map straight to a corner and on, or to the goal itself where that
/// corner is one of those around it. Headings in the map.
WayField::Way WayField::through(const Point& from, Index corner) const {
  const Cell& next = cells_[static_cast<std::size_t>(corner)];
  const bool at_goal = next.corner == corner || next.fifths == 0;
  Point to = centreOf(corner);
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
  const Index at = indexOf(world_x_m, world_y_m);
  if (at < 0) return std::nullopt;
  Index best = at;
  if (cells_[static_cast<std::size_t>(at)].fifths < 0) {
    best = -1;
    for (Index r = std::max(0, at / columns_ - 1); r <= std::min(rows_ - 1, at / columns_ + 1);
         ++r) {
      for (Index c = std::max(0, at % columns_ - 1); c <= std::min(columns_ - 1, at % columns_ + 1);
           ++c) {
        const Index beside = r * columns_ + c;
        const Cell& cell = cells_[static_cast<std::size_t>(beside)];
        if (cell.fifths >= 0 &&
            (best < 0 || cell.fifths < cells_[static_cast<std::size_t>(best)].fifths)) {
          best = beside;
        }
      }
    }
    if (best < 0) return std::nullopt;
  }
  const Obstacles::Point from = question_.obstacles->mapFromWorld(world_x_m, world_y_m);
  Index corner = cells_[static_cast<std::size_t>(best)].corner;
  const Point to = centreOf(corner);
  if (std::hypot(to.x_m - from.x_m, to.y_m - from.y_m) < 2.0 * cell_m_) {
    corner = cells_[static_cast<std::size_t>(corner)].corner;
  }
  Way way = through({from.x_m, from.y_m}, corner);
  const double turn_rad = question_.obstacles->worldFromMap().yaw_rad;
  way.direction_rad += turn_rad;
  way.arrival_rad += turn_rad;
  return way;
}

double WayField::atLeast_m(double world_x_m, double world_y_m) const {
  const Index at = indexOf(world_x_m, world_y_m);
  std::int32_t fifths = at < 0 ? kUnseen : cells_[static_cast<std::size_t>(at)].fifths;
  if (fifths < 0) {
    if (!reached_) return kInfinity;
    fifths = farthest_fifths_;
  }
  return std::clamp((fifths / 5.0 - kEnds) * cell_m_ / kLongest, 0.0, most_m_);
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
  for (Index cell = 0; cell < columns_ * rows_; ++cell) {
    if (cells_[static_cast<std::size_t>(cell)].fifths < 0) continue;
    const Point at = centreOf(cell);
    const double off_m = std::hypot(at.x_m - wish.x_m, at.y_m - wish.y_m);
    if (off_m >= least_m) continue;
    const Pose2 pose = world_from_map * Pose2{at.x_m, at.y_m, wish.yaw_rad};
    if (!question_.obstacles->isFree(pose)) continue;
    nearest = pose;
    least_m = off_m;
  }
  return nearest;
}

}  // namespace hexapod
