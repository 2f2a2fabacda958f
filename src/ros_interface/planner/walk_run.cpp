#include "ros_interface/planner/walk_run.h"

#include <utility>

#include "ros_interface/common/conversions.h"

namespace hexapod {
namespace {

using Code = hexapod_repertoire::GoTo::Response;

// Beyond its own duration: the executor's ramp to the neutral pose and the transport.
constexpr double kBehaviorGrace_s = 5.0;

}  // namespace

WalkRun::WalkRun(const Means& means, const WalkGoal& goal, std::shared_ptr<AdaptivePlanner> planner)
    : means_(means),
      goal_(goal),
      planner_(std::move(planner)),
      walk_(planner_, goal.pose, goal.tolerance) {}

WalkReport WalkRun::run() {
  means_.display.showGoal(goal_.pose);
  while (measure()) {
    const std::optional<PlannedStep> step = plan();
    if (!step || !play(*step)) break;
  }
  return report_;
}

bool WalkRun::measure() {
  const PoseReading robot = means_.poses.robotPose(rest_);
  if (!robot.pose) {
    end(Code::POSE_LOST, robot.problem);
    return false;
  }
  if (played_) {
    means_.display.reportStep(goal_.id, report_.steps, *played_, walked_.back(), *robot.pose);
  }
  walked_.push_back(*robot.pose);
  report_.final_pose.header.frame_id = means_.options.global_frame;
  report_.final_pose.header.stamp = ros::Time::now();
  report_.final_pose.pose = toPoseMsg(*robot.pose);
  report_.final_xy_error_m = distance(*robot.pose, goal_.pose);
  report_.final_yaw_error_rad = headingDistance(*robot.pose, goal_.pose);
  const std::string reason = means_.reasonToEnd();
  if (!reason.empty()) end(Code::PREEMPTED, reason);
  return reason.empty();
}

std::optional<PlannedStep> WalkRun::plan() {
  const Pose2& robot = walked_.back();
  const Walk::Decision decision = walk_.decide(robot, means_.interrupted);
  means_.display.showPlan(robot, decision.plan, walked_, goal_.pose, goal_.tolerance.xy_m);
  if (report_.steps == 0) {
    report_.plan = pathOf(robot, decision.plan, means_.options.global_frame);
  }
  if (decision.state != WalkState::kStep) {
    end(codeOf(decision), decision.message);
    return std::nullopt;
  }
  if (goal_.progress) {
    goal_.progress(report_.final_pose, report_.steps,
                   report_.steps + static_cast<std::uint32_t>(decision.plan.steps.size()),
                   report_.final_xy_error_m);
  }
  return decision.step;
}

bool WalkRun::play(const PlannedStep& step) {
  const Repertoire& repertoire = planner_->repertoire();
  const BehaviorClient::Result result =
      means_.executor.play(repertoire.entries.at(step.entry), repertoire.run_id,
                           repertoire.behavior_duration_s + kBehaviorGrace_s, means_.interrupted);
  if (result.end == BehaviorClient::End::kFault || result.end == BehaviorClient::End::kNotReady) {
    end(Code::EXECUTOR_FAULT, "The executor stopped the walk: " + result.message);
    return false;
  }
  ++report_.steps;
  played_.reset();  // a behaviour that was broken off says nothing of its prediction
  if (result.end == BehaviorClient::End::kPlayed) played_ = step;
  rest_ = result.finished.isZero() ? ros::Time(0)
                                   : result.finished + ros::Duration(means_.options.pose_settle_s);
  return true;
}

void WalkRun::end(std::uint8_t code, const std::string& message) {
  report_.code = code;
  report_.message = message;
}

}  // namespace hexapod
