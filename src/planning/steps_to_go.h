#pragma once

#include <vector>

#include "planning/move.h"
#include "planning/way_field.h"

namespace hexapod {

/// Estimate of the behaviours that a goal still takes, to order the search: turn towards the goal
/// or away from it, drive there forwards or backwards, turn into its heading. What a repertoire
/// cannot do (only forward, only left turns) makes the detour longer. Neither a lower nor an upper
/// bound.
class StepsToGo {
 public:
  /// What lies ahead of the robot.
  struct Ahead {
    double length_m = 0.0;       ///< of the way
    double direction_rad = 0.0;  ///< in which it begins, seen from the robot
    double bend_rad = 0.0;       ///< between the directions of its beginning and its end
    double heading_rad = 0.0;    ///< of the goal, seen from the robot
  };

  explicit StepsToGo(const std::vector<Move>& moves);

  /// Behaviours; the heading of the goal plays no part when `any_heading`. Angles in -pi .. pi.
  double operator()(const Ahead& ahead, bool any_heading) const;
  /// Straight to the goal.
  double operator()(const Pose2& start_from_goal, bool any_heading) const;
  /// Along the ways to it, which lies in that heading from the robot; infinite where none begins.
  double operator()(const WayField& ways, const Pose2& world_from_robot, double goal_heading_rad,
                    bool any_heading) const;

  /// Longest distance that one behaviour covers [m].
  double reach_m() const { return reach_m_; }

 private:
  double turning(double angle_rad) const;

  double reach_m_ = 0.0;
  double forward_m_ = 0.0;   ///< per behaviour
  double backward_m_ = 0.0;  ///< per behaviour
  double left_rad_ = 0.0;    ///< per behaviour
  double right_rad_ = 0.0;   ///< per behaviour
};

}  // namespace hexapod
