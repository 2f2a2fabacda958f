#include "ros_interface/planner/action_doors.h"

namespace hexapod {
namespace {

/// What the results of both actions say alike.
template <class Result>
Result resultOf(const WalkReport& report) {
  Result result;
  result.code = report.code;
  result.message = report.message;
  result.plan = report.plan;
  result.plan_summary = report.plan_summary;
  result.nearest_pose = report.nearest_pose;
  result.final_pose = report.final_pose;
  result.final_xy_error_m = static_cast<float>(report.final_xy_error_m);
  result.final_yaw_error_rad = static_cast<float>(report.final_yaw_error_rad);
  result.steps = report.steps;
  return result;
}

/// And the feedback.
template <class Feedback>
Feedback feedbackOf(const WalkProgress& progress) {
  Feedback feedback;
  feedback.pose = progress.pose;
  feedback.step = progress.steps;
  feedback.steps_planned = progress.steps_planned;
  feedback.distance_left_m = static_cast<float>(progress.distance_left_m);
  return feedback;
}

GoalRequest walkToRequest(const hexapod_repertoire::WalkToGoal& goal) {
  GoalRequest request;
  request.pose = goal.target_pose;
  request.xy_tolerance_m = goal.xy_tolerance_m;
  request.yaw_tolerance_rad = goal.yaw_tolerance_rad;
  request.plan_only = goal.plan_only != 0;
  return request;
}

GoalRequest walkRouteRequest(const hexapod_repertoire::WalkRouteGoal& goal) {
  GoalRequest request;
  request.plan_only = goal.plan_only != 0;
  if (goal.waypoints.empty()) {
    request.problem = "The route has no waypoints; give at least one.";
    return request;
  }
  for (const hexapod_repertoire::Waypoint& waypoint : goal.waypoints) {
    request.via.push_back({waypoint.pose, waypoint.xy_tolerance_m, waypoint.yaw_tolerance_rad});
  }
  static_cast<PoseRequest&>(request) = request.via.back();
  request.via.pop_back();
  return request;
}

hexapod_repertoire::WalkRouteResult walkRouteResult(const WalkReport& report) {
  auto result = resultOf<hexapod_repertoire::WalkRouteResult>(report);
  result.waypoints_reached = report.waypoints;
  return result;
}

hexapod_repertoire::WalkRouteFeedback walkRouteFeedback(const WalkProgress& progress) {
  auto feedback = feedbackOf<hexapod_repertoire::WalkRouteFeedback>(progress);
  feedback.waypoint = progress.waypoint;
  return feedback;
}

GoalRequest moveBaseRequest(const move_base_msgs::MoveBaseGoal& goal) {
  GoalRequest request;
  request.pose = goal.target_pose;
  return request;
}

move_base_msgs::MoveBaseResult moveBaseResult(const WalkReport&) { return {}; }

move_base_msgs::MoveBaseFeedback moveBaseFeedback(const WalkProgress& progress) {
  move_base_msgs::MoveBaseFeedback feedback;
  feedback.base_position = progress.pose;
  return feedback;
}

}  // namespace

ActionDoors::ActionDoors(const ros::NodeHandle& node, ros::CallbackQueueInterface& queue,
                         Walker& walker)
    : walk_to_(node, queue, walker, "walk_to",
               {walkToRequest, resultOf<hexapod_repertoire::WalkToResult>,
                feedbackOf<hexapod_repertoire::WalkToFeedback>}),
      walk_route_(node, queue, walker, "walk_route",
                  {walkRouteRequest, walkRouteResult, walkRouteFeedback}),
      move_base_(node, queue, walker, "move_base",
                 {moveBaseRequest, moveBaseResult, moveBaseFeedback}) {}

}  // namespace hexapod
