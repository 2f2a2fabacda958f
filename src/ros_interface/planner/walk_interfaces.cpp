#include "ros_interface/planner/walk_interfaces.h"

#include <ros/console.h>

#include <cmath>
#include <future>
#include <sstream>

#include "ros_interface/common/conversions.h"

namespace hexapod {
namespace {

using Code = hexapod_repertoire::GoTo::Response;

// A walk ends a waiting call; a newer goal or a cancel does too. So few threads serve any number.
constexpr std::uint32_t kWaitingThreads = 4;

hexapod_repertoire::WalkToResult toResult(const WalkReport& report) {
  hexapod_repertoire::WalkToResult result;
  result.code = report.code;
  result.message = report.message;
  result.plan = report.plan;
  result.final_pose = report.final_pose;
  result.final_xy_error_m = static_cast<float>(report.final_xy_error_m);
  result.final_yaw_error_rad = static_cast<float>(report.final_yaw_error_rad);
  result.steps = report.steps;
  return result;
}

// The tolerance a client asked for; a problem as a sentence when it asked for an impossible one.
GoalTolerance toleranceOf(double xy_m, double yaw_rad, const GoalTolerance& standard,
                          std::string& problem) {
  GoalTolerance tolerance = standard;
  if (!std::isfinite(xy_m) || !std::isfinite(yaw_rad) || xy_m < 0.0) {
    std::ostringstream sentence;
    sentence << "The tolerances are refused: xy " << xy_m << " m, yaw " << yaw_rad
             << " rad; expected finite numbers, xy >= 0 (0: the node's default, negative yaw: any "
                "heading).";
    problem = sentence.str();
  }
  if (xy_m > 0.0) tolerance.xy_m = xy_m;
  if (yaw_rad != 0.0) tolerance.yaw_rad = yaw_rad;
  return tolerance;
}

}  // namespace

WalkInterfaces::WalkInterfaces(ros::NodeHandle& node, ros::NodeHandle& private_node, Walker& walker,
                               const PlannerNodeOptions& options)
    : walker_(walker),
      options_(options),
      action_(
          node, "walk_to", [this](WalkHandle handle) { actionGoal(handle); },
          [this](WalkHandle handle) { actionCancel(handle); }, false),
      waiting_spinner_(kWaitingThreads, &waiting_queue_) {
  auto waiting = ros::AdvertiseServiceOptions::create<hexapod_repertoire::GoTo>(
      "go_to", [this](auto& request, auto& response) { return goTo(request, response); },
      ros::VoidConstPtr(), &waiting_queue_);
  go_to_ = node.advertiseService(waiting);
  make_plan_ = node.advertiseService("make_plan", &WalkInterfaces::makePlan, this);
  cancel_ = private_node.advertiseService("cancel", &WalkInterfaces::cancel, this);
  simple_goal_ = node.subscribe("move_base_simple/goal", 1, &WalkInterfaces::simpleGoal, this);
  action_.start();
  waiting_spinner_.start();
}

WalkReport WalkInterfaces::examine(const Asked& asked, WalkGoal& goal) const {
  WalkReport report;
  std::string problem;
  goal.tolerance = toleranceOf(asked.xy_tolerance_m, asked.yaw_tolerance_rad,
                               options_.planner.tolerance(), problem);
  if (!problem.empty()) {
    report.code = Code::INVALID_GOAL;
    report.message = problem;
    return report;
  }
  if (!fromPoseMsg(asked.pose.pose, problem)) {
    report.code = Code::INVALID_GOAL;
    report.message = "The goal is refused: " + problem + ".";
    return report;
  }
  const PoseReading reading = walker_.poses().goalPose(asked.pose);
  if (!reading.pose) {
    report.code = Code::UNKNOWN_FRAME;
    report.message = reading.problem;
    return report;
  }
  goal.pose = *reading.pose;
  return walker_.makePlan(goal.pose, goal.tolerance);
}

bool WalkInterfaces::goTo(hexapod_repertoire::GoTo::Request& request,
                          hexapod_repertoire::GoTo::Response& response) {
  WalkGoal goal;
  WalkReport report =
      examine({request.target_pose, request.xy_tolerance_m, request.yaw_tolerance_rad}, goal);
  response.plan = report.plan;
  response.accepted = report.code == Code::SUCCEEDED;
  if (response.accepted) {
    const auto end = std::make_shared<std::promise<WalkReport>>();
    auto walked = end->get_future();
    goal.finished = [end](const WalkReport& final_report) { end->set_value(final_report); };
    response.goal_id = walker_.submit(goal);
    if (request.wait) report = walked.get();
  }
  response.code = report.code;
  response.message = report.message;
  response.final_pose = report.final_pose;
  response.final_xy_error_m = static_cast<float>(report.final_xy_error_m);
  response.final_yaw_error_rad = static_cast<float>(report.final_yaw_error_rad);
  response.steps = report.steps;
  return true;
}

bool WalkInterfaces::makePlan(nav_msgs::GetPlan::Request& request,
                              nav_msgs::GetPlan::Response& response) {
  WalkGoal goal;
  WalkReport report = examine({request.goal, request.tolerance, 0.0}, goal);
  // As move_base: an empty start means where the robot stands.
  if (!request.start.header.frame_id.empty()) {
    const PoseReading start = walker_.poses().goalPose(request.start);
    if (!start.pose) {
      report.code = Code::UNKNOWN_FRAME;
      report.message = start.problem;
    } else if (report.code != Code::INVALID_GOAL && report.code != Code::UNKNOWN_FRAME) {
      report = walker_.makePlan(*start.pose, goal.pose, goal.tolerance);
    }
  }
  if (report.code != Code::SUCCEEDED) ROS_WARN_STREAM("make_plan: " << report.message);
  if (report.code == Code::SUCCEEDED) response.plan = report.plan;
  return true;
}

bool WalkInterfaces::cancel(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  response.success = walker_.cancel();
  response.message =
      response.success ? "The walk is being broken off." : "There is no walk to cancel.";
  return true;
}

void WalkInterfaces::simpleGoal(const geometry_msgs::PoseStamped::ConstPtr& message) {
  WalkGoal goal;
  const WalkReport report = examine({*message, 0.0, 0.0}, goal);
  if (report.code == Code::SUCCEEDED) {
    walker_.submit(goal);
  } else {
    ROS_WARN_STREAM("move_base_simple/goal: " << report.message);
  }
}

void WalkInterfaces::actionGoal(WalkHandle handle) {
  const auto asked = handle.getGoal();
  WalkGoal goal;
  const WalkReport report =
      examine({asked->target_pose, asked->xy_tolerance_m, asked->yaw_tolerance_rad}, goal);
  if (report.code != Code::SUCCEEDED) {
    handle.setRejected(toResult(report), report.message);
    return;
  }
  handle.setAccepted();
  if (asked->plan_only) {
    handle.setSucceeded(toResult(report), report.message);
    return;
  }
  goal.finished = [handle](const WalkReport& end) mutable {
    if (end.code == Code::SUCCEEDED) {
      handle.setSucceeded(toResult(end), end.message);
    } else if (end.code == Code::PREEMPTED) {
      handle.setCanceled(toResult(end), end.message);
    } else {
      handle.setAborted(toResult(end), end.message);
    }
  };
  goal.progress = [handle](const geometry_msgs::PoseStamped& pose, std::uint32_t step,
                           std::uint32_t planned, double left_m) mutable {
    hexapod_repertoire::WalkToFeedback feedback;
    feedback.pose = pose;
    feedback.step = step;
    feedback.steps_planned = planned;
    feedback.distance_left_m = static_cast<float>(left_m);
    handle.publishFeedback(feedback);
  };
  goal.id = handle.getGoalID().id;
  walker_.submit(goal);
}

void WalkInterfaces::actionCancel(WalkHandle handle) { walker_.cancel(handle.getGoalID().id); }

}  // namespace hexapod
