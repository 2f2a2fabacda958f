#pragma once

#include <cstdint>
#include <vector>

#include "common/options.h"
#include "repertoire/steadiness.h"

namespace hexapod {

/// How near to the goal counts as arrived.
struct GoalTolerance {
  double xy_m = 0.05;     ///< > 0
  double yaw_rad = 0.17;  ///< > 0; negative: any heading will do

  bool anyHeading() const { return yaw_rad < 0.0; }
};

/// Options of the planner.
struct PlannerOptions {
  double xy_tolerance_m = GoalTolerance{}.xy_m;
  double yaw_tolerance_rad = GoalTolerance{}.yaw_rad;
  double planning_time_s = 0.5;
  std::int64_t max_steps = 60;
  double max_goal_distance_m = 20.0;
  SteadinessOptions steadiness;
  double unvalidated_spread_m = 0.015;
  double unvalidated_spread_rad = 0.03;
  double spread_weight = 0.3;
  double margin_weight = 0.4;
  double recovery_steps = 3.0;
  std::int64_t beam_width = 400;
  std::int64_t max_pairs = 1000000;

  /// The tolerance of a goal that names none.
  GoalTolerance tolerance() const { return {xy_tolerance_m, yaw_tolerance_rad}; }
};

/// Name, unit, range and meaning of each option, bound to the fields of `options`.
std::vector<Option> declareOptions(PlannerOptions& options);

}  // namespace hexapod
