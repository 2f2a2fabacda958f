#pragma once

#include <string>
#include <vector>

#include "common/options.h"
#include "planning/obstacles.h"
#include "planning/plan.h"
#include "ros_interface/robot_client/pose_options.h"

namespace hexapod {

/// How the planner adapts to the robot: the choices of the option adaptation.
struct Adaptation {
  static constexpr const char* kNone = "none";             ///< the repertoire is taken at its word
  static constexpr const char* kSelfModel = "self_model";  ///< SelfImage
};

/// Options of the planner node: those of the planner, and where poses come from.
struct PlannerNodeOptions {
  PlannerOptions planner;
  std::string robot_config;  ///< path; empty: any robot's repertoire is planned with
  PoseOptions pose;
  std::string adaptation = Adaptation::kSelfModel;  ///< one of Adaptation
  double relearn_below = 0.5;                       ///< share of the entries; 0: never
  std::int64_t relearn_evaluations = 30000;
  double planning_wall_time_s = 2.0;  ///< 0: as long as it takes
  bool cmd_vel = false;
  double cmd_vel_timeout_s = 4.0;
  ObstacleOptions obstacles;
  double footprint_radius_m = 0.0;     ///< 0: what the robot's description says
  std::string goal_policy = "refuse";  ///< or nearest
  double blocked_retry_s = 0.0;        ///< 0: a blocked walk ends at once

  GoalPolicy goalPolicy() const {
    return goal_policy == "nearest" ? GoalPolicy::kNearest : GoalPolicy::kRefuse;
  }
};

/// The options under their names, bound to `options`, which must outlive them.
std::vector<Option> declareOptions(PlannerNodeOptions& options);

/// Throws std::invalid_argument when values that are in range each have no meaning.
void checkOptions(const PlannerNodeOptions& options);

}  // namespace hexapod
