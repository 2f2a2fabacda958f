#pragma once

#include <vector>

#include "planning/move.h"

namespace hexapod {

/// Estimate of the behaviours that a goal still takes, to order the search: turn towards the goal
/// or away from it, drive there forwards or backwards, turn into its heading. What a repertoire
/// cannot do (only forward, only left turns) makes the detour longer. Neither a lower nor an upper
/// bound.
class StepsToGo {
 public:
  explicit StepsToGo(const std::vector<Move>& moves);

  /// Behaviours to the goal at `start_from_goal`; its heading plays no part when `any_heading`.
  double operator()(const Pose2& start_from_goal, bool any_heading) const;

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
