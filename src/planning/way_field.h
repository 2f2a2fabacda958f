#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "common/zeroed_array.h"
#include "planning/cell_grid.h"
#include "planning/obstacles.h"

namespace hexapod {

/// Shortest ways of base_footprint to one goal around the obstacles, heading left out: where the
/// inner disc of the footprint fits. Orders the search and bounds it from below. Immutable.
///
/// A wave over square cells from the goal on (steps of 5 and 7 fifths for 1 and sqrt(2): never more
/// than 1.08 times the length of a path through the cells), until the start is reached and a bit
/// farther. Along it every cell takes over the corner that its predecessor heads for as long as it
/// sees that one, which straightens the ways.
class WayField {
 public:
  struct Question {
    std::shared_ptr<const Obstacles> obstacles;
    Pose2 world_from_start;
    Pose2 world_from_goal;
    double radius_m = 0.0;  ///< as near to the goal as that is there
    /// May be empty: asked now and then; ways are looked for no longer once it returns true. Not
    /// kept.
    std::function<bool()> stop = {};
  };

  /// Which cells are open.
  enum class Open {
    kSurely,   ///< where the robot's inner disc is free at the centre
    kPossibly  ///< where it may be free at some point: no path is overlooked
  };

  /// How a way looks from a point.
  struct Way {
    double length_m = 0.0;
    double direction_rad = 0.0;  ///< in which it begins, in the world
    double arrival_rad = 0.0;    ///< in which it ends, in the world
  };

  /// `around_m`: how far from start and goal ways are looked for. Infinite: everywhere.
  WayField(const Question& question, Open open, double around_m);

  /// The pose nearest to the given one, with its heading, that is free and has a way here.
  std::optional<Pose2> freePoseNearest(const Pose2& world_from_wish) const;

  /// The way from a point, if one is known.
  std::optional<Way> wayFrom(double world_x_m, double world_y_m) const;

  /// With kPossibly: every path of base_footprint from there to the goal is at least so long [m];
  /// infinite when there is none. Of places farther than the start: as of the farthest known.
  double atLeast_m(double world_x_m, double world_y_m) const;

  /// Whether it was stopped before it had seen everything: what it does not know there may be.
  bool isCutShort() const { return cut_short_; }

  /// Whether it was made for these obstacles.
  bool isAmong(const std::shared_ptr<const Obstacles>& obstacles) const;

  /// Whether it was made for these obstacles and goal, and knows a way from that start.
  bool answers(const Question& question) const;

 private:
  using Index = CellGrid::Index;
  using Point = CellGrid::Point;

  /// All zero where the wave has not come.
  struct Cell {
    static constexpr std::int32_t kClosed = -1;

    std::int32_t state;  ///< 0: not seen; otherwise kClosed or 1 + fifths
    Index corner;        ///< cell that the way from here heads for in a straight line
    float length_m;      ///< straightened
    float arrival_rad;

    bool isSeen() const { return state != 0; }
    bool isReached() const { return state > 0; }
    std::int32_t fifths() const { return state - 1; }  ///< to the goal, in fifths of a cell
  };

  void layOut(double around_m);
  Cell& at(Index cell) { return cells_[static_cast<std::size_t>(cell)]; }
  const Cell& at(Index cell) const { return cells_[static_cast<std::size_t>(cell)]; }
  Point inMap(double world_x_m, double world_y_m) const;
  bool isOpen(Index cell) const;
  bool sees(const Point& from, const Point& to) const;
  std::vector<Index> seeds() const;
  void spread();
  bool take(Index cell, Index predecessor, std::int32_t fifths);
  bool isAtStart(Index cell) const;
  void straighten(Index cell, Index predecessor);
  Way through(const Point& from, Index corner) const;

  Question question_;
  Open open_;
  CellGrid grid_;
  Index start_ = -1;
  double most_m_ = 0.0;  ///< paths from start to goal that leave the cells are longer
  std::int32_t farthest_fifths_ = 0;
  bool reached_ = false;
  bool cut_short_ = false;
  ZeroedArray<Cell> cells_;
};

}  // namespace hexapod
