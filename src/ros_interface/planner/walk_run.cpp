#include "ros_interface/planner/walk_run.h"

#include <algorithm>
#include <utility>

#include "ros_interface/common/conversions.h"
#include "ros_interface/planner/walk_display.h"

namespace hexapod {
namespace {

// A walk ends when the pose has been lost for so long, beyond pose_timeout_s.
constexpr std::int64_t kPoseMayReturn_ns = kSecond_ns / 2;
// How often a blocked walk looks whether a way has opened.
constexpr std::int64_t kRetry_ns = kSecond_ns / 2;

WalkOptions walkOptions(const PlannerNodeOptions& options) {
  WalkOptions walk_options;
  walk_options.goal_policy = options.goalPolicy();
  return walk_options;
}

// Ways that may open again.
bool isBlocked(const Walk::Decision& decision) {
  return decision.state == WalkState::kNoPlan && (decision.plan.code == PlanCode::kBlocked ||
                                                  decision.plan.code == PlanCode::kGoalOccupied);
}

}  // namespace

WalkRun::WalkRun(const WalkMeans& means, OpenGoal& goal, std::shared_ptr<AdaptivePlanner> planner)
    : means_(means),
      goal_(goal),
      planner_(std::move(planner)),
      route_(goal.goal().route()),
      walk_(planner_, route_, walkOptions(means.options)),
      tally_(means.clock),
      obstacles_(means.obstacles) {
  // Of a route only the way to the next waypoint is planned again.
  const WalkReport accepted = goal.report();
  report_.plan = accepted.plan;
  report_.plan_summary = accepted.plan_summary;
}

WalkReport WalkRun::run() {
  means_.watcher.showGoal(route_.front().world_from_goal);
  if (!awaitRest()) return report_;
  while (measure()) {
    const std::optional<PlannedStep> step = plan();
    if (!step || !play(*step)) break;
  }
  return report_;
}

bool WalkRun::awaitRest() {
  const auto ready =
      means_.player.awaitReady(goal_.stops, [this] { return goal_.ended() || isLost(); });
  if (goal_.ended()) return false;
  if (ready.end != BehaviorPlayer::End::kPlayed) {
    end(codeOf(ready.end), "The walk ended, no behaviour is played: " + ready.message);
    return false;
  }
  rest_ = restAfter(ready.finished);
  return true;
}

ros::Time WalkRun::restAfter(const ros::Time& last_command) const {
  return last_command + ros::Duration(means_.options.pose.pose_settle_s);
}

bool WalkRun::measure() {
  const PoseReading robot = means_.poses.restPose(rest_, [this] { return goal_.ended(); });
  if (goal_.ended()) return false;  // whoever ended it has told why
  if (!robot.pose) {
    end(GoalCode::POSE_LOST, robot.problem);
    return false;
  }
  if (played_) {
    means_.watcher.reportStep(goal_.id, report_.steps, *played_, walked_.back().measured,
                              *robot.pose);
    tally_.noteStep(played_->world_from_end, *robot.pose);
  }
  walked_.push_back({*robot.pose, std::nullopt});
  if (played_) walked_.back().predicted = played_->world_from_end;
  tally_.noteRest(*robot.pose);
  noteWhereRobotIs(*robot.pose);
  if (!means_.newer_is_next()) return true;
  end(GoalCode::PREEMPTED, "A newer goal took over.");
  return false;
}

void WalkRun::noteWhereRobotIs(const Pose2& robot) {
  report_.final_pose.header.frame_id = means_.options.pose.global_frame;
  report_.final_pose.header.stamp = means_.clock.rosNow();
  report_.final_pose.pose = toPoseMsg(robot);
  report_.final_xy_error_m = distance(robot, goal_.goal().pose);
  report_.final_yaw_error_rad = headingDistance(robot, goal_.goal().pose);
  if (obstacles_.seen()) tally_.noteClearance(obstacles_.seen()->clearance_m(robot));
  report_.tally = tally_.tally();
  goal_.note(report_);
}

Walk::Decision WalkRun::decide() {
  walk_.setObstacles(obstacles_.look());
  goal_.is_thought_about = true;
  Walk::Decision decision =
      walk_.decide(walked_.back().measured,
                   withinWallTime(means_.options, means_.clock, [this] { return goal_.ended(); }));
  goal_.is_thought_about = false;
  return decision;
}

Walk::Decision WalkRun::decideOnceOpen() {
  const std::int64_t until_ns =
      means_.clock.steadyNow_ns() +
      static_cast<std::int64_t>(means_.options.blocked_retry_s * static_cast<double>(kSecond_ns));
  Walk::Decision decision = decide();
  const auto isOver = [this] { return goal_.ended() || means_.newer_is_next(); };
  while (isBlocked(decision) && !isOver() && means_.clock.steadyNow_ns() < until_ns) {
    means_.clock.waitUntil(means_.clock.steadyNow_ns() + kRetry_ns, isOver);
    if (means_.obstacles && !obstacles_.isOutdated()) continue;
    walk_.disregardLastStep();
    decision = decide();
  }
  return decision;
}

std::optional<PlannedStep> WalkRun::plan() {
  const Pose2& robot = walked_.back().measured;
  const WalkGoal& goal = goal_.goal();
  const Walk::Decision decision = decideOnceOpen();
  if (goal_.ended()) return std::nullopt;
  const Waypoint& waypoint = route_[decision.waypoint];
  if (decision.waypoint != report_.waypoints) means_.watcher.showGoal(waypoint.world_from_goal);
  report_.waypoints = static_cast<std::uint32_t>(decision.waypoint);
  means_.watcher.showPlan(robot, decision.plan, walked_, waypoint.world_from_goal,
                          waypoint.tolerance.xy_m);
  WalkReport now;
  fillIn(robot, decision.plan, means_.options.pose.global_frame, means_.clock.rosNow(), now);
  report_.nearest_pose = now.nearest_pose;
  if (report_.steps == 0 && route_.size() == 1) {
    report_.plan = now.plan;
    report_.plan_summary = now.plan_summary;
  }
  tally_.notePlan(decision.plan);
  if (decision.state != WalkState::kStep) {
    // Where it was led instead is not where it was to go.
    const bool elsewhere = decision.state == WalkState::kArrived &&
                           distance(decision.plan.world_from_target, goal.pose) > 0.0;
    end(elsewhere ? std::uint8_t{GoalCode::GOAL_OCCUPIED} : codeOf(decision), decision.message);
    if (report_.success()) ++report_.waypoints;
    return std::nullopt;
  }
  goal_.tellProgress({report_.final_pose, report_.steps,
                      report_.steps + static_cast<std::uint32_t>(decision.plan.steps.size()),
                      distance(robot, waypoint.world_from_goal), report_.waypoints});
  return decision.step;
}

bool WalkRun::isToBreakOff() {
  if (goal_.ended()) return true;
  touches_ =
      touches_ || obstacles_.touchesNews(*planner_->planner(), walked_.back().measured, entry_);
  return touches_ || isLost();
}

bool WalkRun::isLost() {
  const PoseReading robot = means_.poses.latest();
  if (robot.pose) {
    noteWhereRobotIs(*robot.pose);
  } else if (robot.silent_ns >
             secondsToNs(means_.options.pose.pose_timeout_s) + kPoseMayReturn_ns) {
    // Told now: an executor whose time stands does not answer when it is to break off.
    end(GoalCode::POSE_LOST, robot.problem);
    goal_.end(report_);
  }
  return goal_.ended();
}

bool WalkRun::play(const PlannedStep& step) {
  const Repertoire& repertoire = planner_->repertoire();
  entry_ = step.entry;
  touches_ = false;
  const BehaviorPlayer::Result result =
      means_.player.play({repertoire.entries.at(step.entry), repertoire.run_id, goal_.stops,
                          [this] { return isToBreakOff(); }});
  if (goal_.ended()) return false;
  if (touches_ && result.end == BehaviorPlayer::End::kCancelled) {
    ++report_.steps;
    walk_.disregardLastStep();
    played_.reset();
    return awaitRest();
  }
  if (result.end != BehaviorPlayer::End::kPlayed) {
    end(codeOf(result.end), "The walk ended, no behaviour is played: " + result.message);
    return false;
  }
  ++report_.steps;
  played_ = step;
  walk_.noteJoints(result.joints);
  if (result.skipped > 0) {
    walk_.disregardLastStep();
    played_.reset();
  }
  rest_ = restAfter(result.finished);
  return true;
}

void WalkRun::end(std::uint8_t code, const std::string& message) {
  report_.code = code;
  report_.message = message;
}

}  // namespace hexapod
