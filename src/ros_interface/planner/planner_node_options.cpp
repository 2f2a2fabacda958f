#include "ros_interface/planner/planner_node_options.h"

#include <stdexcept>

namespace hexapod {

std::vector<Option> declareOptions(PlannerNodeOptions& options) {
  std::vector<Option> all = declareOptions(options.planner);
  all.push_back(option("robot_config", options.robot_config,
                       "Path of the robot's YAML, its URDF is the parameter robot_description: "
                       "only repertoires of this robot are planned with. Empty: any robot's."));
  const std::vector<Option> pose = declareOptions(options.pose);
  all.insert(all.end(), pose.begin(), pose.end());
  all.push_back(
      option("adaptation", options.adaptation,
             "none: walk as if the repertoire were right. self_model: believe in the body "
             "that explains what was walked, and plan with what it makes of the "
             "repertoire (needs robot_config).",
             {Adaptation::kNone, Adaptation::kSelfModel}));
  all.push_back(option(
      "relearn_below", options.relearn_below, "",
      "With adaptation self_model: where the believed body leaves less than this "
      "share of the entries that are planned with, more are learned for it in the background, and "
      "planned with as long as it is believed. 0: never.",
      0.0, 1.0));
  all.push_back(option("relearn_evaluations", options.relearn_evaluations,
                       "Behaviours evaluated to learn for a believed body.", std::int64_t{1},
                       std::int64_t{1000000000}));
  all.push_back(option("planning_wall_time_s", options.planning_wall_time_s, "s",
                       "Time by the clock that one plan may take: the best one by then, if there "
                       "is one. 0: only planning_time_s limits it, which counts, so that the same "
                       "goal always gives the same plan.",
                       0.0, 3600.0));
  all.push_back(option("cmd_vel", options.cmd_vel,
                       "Walk by velocities on the topic cmd_vel. A new velocity acts when the "
                       "behaviour under way has ended, a zero one at once."));
  all.push_back(option("cmd_vel_timeout_s", options.cmd_vel_timeout_s, "s",
                       "The robot comes to rest this long after the last velocity; shorter than a "
                       "behaviour, one message starts it and breaks it off.",
                       0.1, 60.0));
  all.push_back(option("unknown_is_free", options.obstacles.unknown_is_free,
                       "Whether the robot may be where the map is unknown or ends."));
  all.push_back(option("footprint_margin_m", options.obstacles.footprint_margin_m, "m",
                       "Room kept between what body and feet sweep and occupied cells.", 0.0,
                       10.0));
  all.push_back(option("narrow_margin_m", options.obstacles.narrow_margin_m, "m",
                       "Room kept, instead of footprint_margin_m, by plans through passages that "
                       "are too narrow for that; at most footprint_margin_m.",
                       0.0, 10.0));
  all.push_back(option("footprint_radius_m", options.footprint_radius_m, "m",
                       "Radius of what body and feet sweep; 0: that of the robot's description, "
                       "which ~robot_config names.",
                       0.0, 100.0));
  all.push_back(option("goal_policy", options.goal_policy,
                       "What is done about a goal where the robot cannot stand: refuse it, or walk "
                       "to the nearest free pose that has a way.",
                       {"refuse", "nearest"}));
  all.push_back(option("blocked_retry_s", options.blocked_retry_s, "s",
                       "How long a walk waits, standing, for a way that obstacles close to open "
                       "again; 0: it ends at once.",
                       0.0, 86400.0));
  return all;
}

void checkOptions(const PlannerNodeOptions& options) {
  if (options.planner.yaw_tolerance_rad != 0.0) return;
  throw std::invalid_argument(
      "~yaw_tolerance_rad is 0, which no robot arrives with; expected a positive angle [rad], or a "
      "negative number for any heading.");
}

}  // namespace hexapod
