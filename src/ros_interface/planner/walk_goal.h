#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Path.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hexapod_repertoire/GoTo.h"
#include "planning/planner.h"
#include "planning/route.h"
#include "planning/walk.h"
#include "ros_interface/robot_client/behavior_player.h"

namespace hexapod {

/// The codes that goals end with, wherever they came from.
using GoalCode = hexapod_repertoire::GoTo::Response;

/// A velocity in the plane, of base_footprint.
struct Twist {
  double x_m_per_s = 0.0;
  double y_m_per_s = 0.0;
  double yaw_rad_per_s = 0.0;

  bool operator!=(const Twist& other) const {
    return x_m_per_s != other.x_m_per_s || y_m_per_s != other.y_m_per_s ||
           yaw_rad_per_s != other.yaw_rad_per_s;
  }
};

/// A pose as a client sent it.
struct PoseRequest {
  geometry_msgs::PoseStamped pose;
  double xy_tolerance_m = 0.0;     ///< 0: the node's default
  double yaw_tolerance_rad = 0.0;  ///< 0: the node's default; negative: any heading
};

/// A goal as a client sent it.
struct GoalRequest : PoseRequest {
  std::vector<PoseRequest> via;  ///< to be passed before, in this order
  std::string problem;           ///< why it is refused whatever is known of the robot, or empty
  bool plan_only = false;
  ros::Time sent;  ///< by the client's clock; zero: not told
  /// Instead of a pose: walk as it says until it says nothing any more. Asked often.
  std::function<std::optional<Twist>()> twist;
};

/// A goal that was examined: in the global frame.
struct WalkGoal {
  Pose2 pose;
  GoalTolerance tolerance;
  std::vector<Waypoint> via = {};  ///< to be passed before

  /// All of them, in order.
  std::vector<Waypoint> route() const {
    std::vector<Waypoint> all = via;
    all.push_back({pose, tolerance});
    return all;
  }
};

/// What a walk was like, so far.
struct WalkTally {
  std::uint32_t replans = 0;  ///< plans that were not what was left of the one before
  double duration_s = 0.0;
  double distance_m = 0.0;     ///< walked, between the poses measured at rest
  std::uint32_t measured = 0;  ///< behaviours whose ends were predicted, and measured at rest
  double xy_error_m = 0.0;     ///< mean over those, from their predictions
  double yaw_error_rad = 0.0;
  double clearance_m = std::numeric_limits<double>::infinity();  ///< least, at measured poses
};

/// What became of a goal: a code of GoTo.srv, a sentence, the first plan, the end.
struct WalkReport {
  std::uint8_t code = GoalCode::INTERNAL_ERROR;
  std::string message;
  nav_msgs::Path plan;
  hexapod_repertoire::PlanSummary plan_summary;
  geometry_msgs::PoseStamped nearest_pose;  ///< without a frame: none was looked for
  WalkTally tally;
  geometry_msgs::PoseStamped final_pose;
  double final_xy_error_m = 0.0;
  double final_yaw_error_rad = 0.0;
  std::uint32_t steps = 0;
  std::uint32_t waypoints = 0;  ///< arrived at

  bool success() const { return code == GoalCode::SUCCEEDED; }
};

/// Where the robot may be, asked before each plan and during each behaviour; null: everywhere. The
/// same object as long as nothing has changed.
using ObstacleSource = std::function<std::shared_ptr<const Obstacles>()>;

/// Why it is not known where the robot may be, asked of each goal: a sentence, or empty.
using ObstacleProblem = std::function<std::string()>;

/// How far a walk is, told before each behaviour.
struct WalkProgress {
  geometry_msgs::PoseStamped pose;
  std::uint32_t steps = 0;          ///< behaviours done
  std::uint32_t steps_planned = 0;  ///< those done included
  double distance_left_m = 0.0;     ///< to the waypoint
  std::uint32_t waypoint = 0;       ///< that is walked to
};

/// Who wants to know of a goal. Called from various threads, one at a time: accepted at most once,
/// then progress, then ended exactly once. An end without acceptance is a refusal. Any may be
/// empty.
struct GoalListener {
  std::function<void(const WalkReport&)> accepted;
  std::function<void(const WalkProgress&)> progress;
  std::function<void(const WalkReport&)> ended;
};

/// Of a goal whose cancel overtook it on the way.
WalkReport cancelledEarly();

/// The code of GoTo.srv for how planning ended.
std::uint8_t codeOf(PlanCode code);

/// The code of GoTo.srv for what a walk has come to.
std::uint8_t codeOf(const Walk::Decision& decision);

/// The code of GoTo.srv for a behaviour that was not played to its end.
std::uint8_t codeOf(BehaviorPlayer::End end);

}  // namespace hexapod
