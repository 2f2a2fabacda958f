#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Path.h>

#include <cstdint>
#include <functional>
#include <string>

#include "hexapod_repertoire/GoTo.h"
#include "planning/planner.h"
#include "planning/walk.h"

namespace hexapod {

/// What became of a goal: a code of GoTo.srv, a sentence, the first plan, the end.
struct WalkReport {
  std::uint8_t code = hexapod_repertoire::GoTo::Response::NO_REPERTOIRE;
  std::string message;
  nav_msgs::Path plan;
  geometry_msgs::PoseStamped final_pose;
  double final_xy_error_m = 0.0;
  double final_yaw_error_rad = 0.0;
  std::uint32_t steps = 0;
};

/// A goal in the global frame, and who wants to know of it.
struct WalkGoal {
  std::string id;  ///< unique; empty: submit() gives one
  Pose2 pose;
  GoalTolerance tolerance;
  std::function<void(const WalkReport&)> finished;  ///< called once, from the walking thread
  /// Called before each behaviour: measured pose, behaviours done, planned in all, metres left.
  std::function<void(const geometry_msgs::PoseStamped&, std::uint32_t, std::uint32_t, double)>
      progress;
};

/// The code of GoTo.srv for how planning ended.
std::uint8_t codeOf(PlanCode code);

/// The code of GoTo.srv for what a walk has come to.
std::uint8_t codeOf(const Walk::Decision& decision);

}  // namespace hexapod
