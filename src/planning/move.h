#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "geometry/pose2.h"
#include "planning/move_path.h"
#include "planning/planner_options.h"
#include "repertoire/repertoire.h"

namespace hexapod {

/// What a radian of heading counts as where ends of behaviours are compared [m].
constexpr double kMetresPerRadian = 0.3;

/// Wraps the sum or difference of two angles in [-pi, pi] into [-pi, pi].
inline double wrapOnce(double angle_rad) {
  if (angle_rad > M_PI) return angle_rad - 2.0 * M_PI;
  return angle_rad < -M_PI ? angle_rad + 2.0 * M_PI : angle_rad;
}

/// What the planner knows of an entry that may be used.
struct Move {
  std::size_t entry = 0;  ///< index in the repertoire
  Pose2 end;              ///< expected end pose in the start frame
  double cosine = 1.0;    ///< of end.yaw_rad
  double sine = 0.0;
  double length_m = 0.0;  ///< distance between start and end
  double spread_m = 0.0;  ///< expected, from the validation and the prior of the options
  double spread_rad = 0.0;
  double cost = 1.0;  ///< behaviours: 1 and the price of its spread
  MovePath path;      ///< of base_footprint, to `end`

  /// The goal as seen after this move: inverse(end) * start_from_goal.
  Pose2 remaining(const Pose2& start_from_goal) const {
    const double x = start_from_goal.x_m - end.x_m;
    const double y = start_from_goal.y_m - end.y_m;
    return {cosine * x + sine * y, cosine * y - sine * x,
            wrapOnce(start_from_goal.yaw_rad - end.yaw_rad)};
  }
};

/// The entries that may be planned with, in the repertoire's order: the steady ones, and never one
/// that fell in its validation, that does not move, or whose pose is not finite.
/// A validated spread counts as much as its number of trials against two trials of the unvalidated
/// spread, so that an entry is not trusted after a single lucky trial.
/// Of more than planning can pair with each other (max_pairs) those that cover the ends of all
/// best. `paths` are theirs by index, where they are known.
std::vector<Move> usableMoves(const Repertoire& repertoire, const PlannerOptions& options,
                              const EntryPaths& paths = {});

/// Indices of at most `count` moves that cover the end poses evenly, best spread first: each next
/// one is the farthest from those chosen (metres; a radian counts as 0.3 m), discounted by its
/// spread. The first one reaches farthest.
std::vector<std::size_t> spreadOut(const std::vector<Move>& moves, std::size_t count);

/// Index of the farthest reaching move in each of `sectors` sectors of direction that has any.
std::vector<std::size_t> farthestPerSector(const std::vector<Move>& moves, std::size_t sectors);

}  // namespace hexapod
