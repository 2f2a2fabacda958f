#include "ros_interface/planner/walk_to_door.h"

namespace hexapod {
namespace {

using Result = hexapod_repertoire::WalkToResult;
using Status = actionlib_msgs::GoalStatus;

Result toResult(const WalkReport& report) {
  Result result;
  result.code = report.code;
  result.message = report.message;
  result.plan = report.plan;
  result.final_pose = report.final_pose;
  result.final_xy_error_m = static_cast<float>(report.final_xy_error_m);
  result.final_yaw_error_rad = static_cast<float>(report.final_yaw_error_rad);
  result.steps = report.steps;
  return result;
}

Result cancelledEarly() {
  Result result;
  result.code = GoalCode::PREEMPTED;
  result.message = "Cancelled before it arrived.";
  return result;
}

hexapod_repertoire::WalkToFeedback toFeedback(const WalkProgress& progress) {
  hexapod_repertoire::WalkToFeedback feedback;
  feedback.pose = progress.pose;
  feedback.step = progress.steps;
  feedback.steps_planned = progress.steps_planned;
  feedback.distance_left_m = static_cast<float>(progress.distance_left_m);
  return feedback;
}

// A goal that ends unaccepted is rejected, unless it was cancelled or overtaken: that is PREEMPTED
// whenever it happens, and actionlib knows it of accepted goals only.
template <class Handle>
void endGoal(Handle& handle, const WalkReport& report) {
  const std::uint8_t status = handle.getGoalStatus().status;
  const bool waits = status == Status::PENDING || status == Status::RECALLING;
  if (report.code == GoalCode::PREEMPTED) {
    if (waits) handle.setAccepted();
    handle.setCanceled(toResult(report), report.message);
  } else if (waits) {
    handle.setRejected(toResult(report), report.message);
  } else if (report.success()) {
    handle.setSucceeded(toResult(report), report.message);
  } else {
    handle.setAborted(toResult(report), report.message);
  }
}

}  // namespace

WalkToDoor::WalkToDoor(const ros::NodeHandle& node, ros::CallbackQueueInterface& queue,
                       Walker& walker)
    : walker_(walker),
      server_(
          node, "walk_to", queue, [this](Handle handle) { onGoal(handle); },
          [this](Handle handle) { walker_.cancel(handle.getGoalID().id); }, cancelledEarly()) {
  server_.start();
}

void WalkToDoor::onGoal(Handle handle) {
  const auto goal = handle.getGoal();
  GoalListener listener;
  listener.accepted = [handle](const WalkReport&) mutable { handle.setAccepted(); };
  listener.progress = [handle](const WalkProgress& progress) mutable {
    handle.publishFeedback(toFeedback(progress));
  };
  listener.ended = [handle](const WalkReport& report) mutable { endGoal(handle, report); };
  walker_.submit(
      {goal->target_pose, goal->xy_tolerance_m, goal->yaw_tolerance_rad, goal->plan_only != 0},
      listener, handle.getGoalID().id);
}

}  // namespace hexapod
