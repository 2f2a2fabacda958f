#include "planning/planner_options.h"

namespace hexapod {

std::vector<Option> declareOptions(PlannerOptions& options) {
  std::vector<Option> all = {
      option("xy_tolerance_m", options.xy_tolerance_m, "m",
             "distance to the goal that counts as arrived", 0.001, 10.0),
      option("yaw_tolerance_rad", options.yaw_tolerance_rad, "rad",
             "heading error that counts as arrived; negative: any heading will do", -1.0, 3.15),
      option("planning_time_s", options.planning_time_s, "s",
             "work allowed for one plan, as the time it takes on a 2 GHz core; a count of poses "
             "looked at, so that the same goal always gives the same plan",
             0.001, 60.0),
      option("max_steps", options.max_steps, "longest plan, in behaviours", 1, 1000),
      option("max_goal_distance_m", options.max_goal_distance_m, "m",
             "goals farther from the start are refused", 0.01, 1000.0),
      option("unvalidated_spread_m", options.unvalidated_spread_m, "m",
             "position spread assumed of an entry that has not been validated", 0.0, 1.0),
      option("unvalidated_spread_rad", options.unvalidated_spread_rad, "rad",
             "heading spread assumed of an entry that has not been validated", 0.0, 3.0),
      option("spread_weight", options.spread_weight, "",
             "price, in behaviours, of an entry whose spread is as large as the default tolerance",
             0.0, 100.0),
      option("margin_weight", options.margin_weight, "",
             "price, in behaviours, of a predicted end at the rim of the tolerance", 0.0, 0.5),
      option("recovery_steps", options.recovery_steps, "",
             "behaviours that missing the goal is expected to cost", 0.0, 100.0),
      option("beam_width", options.beam_width,
             "poses kept after each behaviour when a goal is more than three behaviours away", 1,
             100000),
      option(
          "max_pairs", options.max_pairs,
          "two-behaviour chains tabulated; where there are more, as many entries as pair up to so "
          "many are planned with, those that cover the ends of all best",
          1, 10000000),
  };
  const std::vector<Option> steadiness = declareOptions(options.steadiness);
  all.insert(all.end(), steadiness.begin(), steadiness.end());
  return all;
}

}  // namespace hexapod
