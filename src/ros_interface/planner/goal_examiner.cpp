#include "ros_interface/planner/goal_examiner.h"

#include <cmath>
#include <sstream>

#include "planning/route_planner.h"
#include "repertoire/import_repertoire.h"
#include "ros_interface/common/conversions.h"
#include "ros_interface/planner/walk_display.h"
#include "ros_interface/planner/walk_means.h"

namespace hexapod {
namespace {

// Latched topics that exist have come by then.
constexpr std::int64_t kStarting_ns = 3 * kSecond_ns;

WalkReport refusal(std::uint8_t code, const std::string& message) {
  WalkReport report;
  report.code = code;
  report.message = message;
  return report;
}

std::string ofWaypoint(std::size_t number, std::size_t count) {
  return "Waypoint " + std::to_string(number) + " of " + std::to_string(count) + ": ";
}

// The tolerance a client asked for; a problem as a sentence when it asked for an impossible one.
GoalTolerance toleranceOf(const PoseRequest& request, const GoalTolerance& standard,
                          std::string& problem) {
  const double xy_m = request.xy_tolerance_m;
  const double yaw_rad = request.yaw_tolerance_rad;
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

GoalExaminer::GoalExaminer(const Means& means)
    : means_(means), start_ns_(means.clock.steadyNow_ns()) {}

GoalExaminer::Examination GoalExaminer::examine(const GoalRequest& request,
                                                const Stop& stop) const {
  if (request.twist) return examineTwist(stop);
  Examination examination;
  auto refused = readGoal(request, stop, examination.goal);
  examination.is_goal_known = !refused;
  if (!refused && !request.plan_only) refused = askPlayer(stop);
  if (!refused) {
    const PoseReading robot = means_.poses.robotPose(stop);
    if (robot.pose) {
      examination.start = *robot.pose;
      plan(stop, examination);
      if (!request.plan_only && examination.report.success() && cannotBePlayed()) {
        examination.report = refusal(GoalCode::NO_REPERTOIRE,
                                     "The repertoire was imported: its entries can be planned with "
                                     "and shown, but not executed. Learn one for this robot.");
      }
      return examination;
    }
    refused = refusal(GoalCode::POSE_LOST, robot.problem);
  }
  examination.report = *refused;
  return examination;
}

bool GoalExaminer::cannotBePlayed() const {
  const auto planner = means_.repertoire.planner();
  return planner && isImported(planner->repertoire());
}

GoalExaminer::Examination GoalExaminer::examineTwist(const Stop& stop) const {
  Examination examination;
  auto refused = askPlayer(stop);
  if (!refused) refused = askRepertoire(stop);
  if (!refused) refused = askMap(stop);
  examination.report = refused ? *refused : refusal(GoalCode::SUCCEEDED, "Walking by velocity.");
  return examination;
}

GoalExaminer::Examination GoalExaminer::examineFrom(const geometry_msgs::PoseStamped& start,
                                                    const GoalRequest& request,
                                                    const Stop& stop) const {
  Examination examination;
  auto refused = readGoal(request, stop, examination.goal);
  WalkGoal from;
  GoalRequest at_start;
  at_start.pose = start;
  if (!refused) refused = readGoal(at_start, stop, from);
  if (refused) {
    examination.report = *refused;
    return examination;
  }
  examination.start = from.pose;
  plan(stop, examination);
  return examination;
}

GoalExaminer::Refusal GoalExaminer::readGoal(const GoalRequest& request, const Stop& stop,
                                             WalkGoal& goal) const {
  if (!request.problem.empty()) return refusal(GoalCode::INVALID_GOAL, request.problem);
  for (const PoseRequest& pose : request.via) {
    goal.via.emplace_back();
    auto refused = readPose(pose, stop, goal.via.back());
    if (!refused) continue;
    refused->message = ofWaypoint(goal.via.size(), request.via.size() + 1) + refused->message;
    return refused;
  }
  Waypoint last;
  auto refused = readPose(request, stop, last);
  goal.pose = last.world_from_goal;
  goal.tolerance = last.tolerance;
  return refused;
}

GoalExaminer::Refusal GoalExaminer::readPose(const PoseRequest& request, const Stop& stop,
                                             Waypoint& waypoint) const {
  std::string problem;
  waypoint.tolerance = toleranceOf(request, means_.options.planner.tolerance(), problem);
  if (!problem.empty()) return refusal(GoalCode::INVALID_GOAL, problem);
  if (!fromPoseMsg(request.pose.pose, problem)) {
    return refusal(GoalCode::INVALID_GOAL, "The goal is refused: " + problem + ".");
  }
  const PoseReading reading = means_.poses.goalPose(request.pose, stop);
  if (!reading.pose) return refusal(GoalCode::UNKNOWN_FRAME, reading.problem);
  waypoint.world_from_goal = *reading.pose;
  return std::nullopt;
}

GoalExaminer::Refusal GoalExaminer::askPlayer(const Stop& stop) const {
  awaitAtStart([this] { return means_.player.whyNotReady().empty(); }, stop);
  const std::string why = means_.player.whyNotReady();
  if (why.empty()) return std::nullopt;
  return refusal(GoalCode::EXECUTOR_NOT_READY, why);
}

GoalExaminer::Refusal GoalExaminer::askRepertoire(const Stop& stop) const {
  awaitAtStart([this] { return means_.repertoire.planner() != nullptr; }, stop);
  if (means_.repertoire.planner()) return std::nullopt;
  return refusal(GoalCode::NO_REPERTOIRE,
                 "No repertoire has arrived on the topic repertoire: start the learner or a "
                 "repertoire_server.");
}

GoalExaminer::Refusal GoalExaminer::askMap(const Stop& stop) const {
  if (!means_.obstacle_problem) return std::nullopt;
  awaitAtStart([this] { return means_.obstacle_problem().empty(); }, stop);
  const std::string why = means_.obstacle_problem();
  if (why.empty()) return std::nullopt;
  return refusal(GoalCode::UNKNOWN_FRAME, why);
}

void GoalExaminer::awaitAtStart(const std::function<bool()>& there, const Stop& stop) const {
  means_.clock.waitUntil(start_ns_ + kStarting_ns, [&] { return there() || stop(); });
}

void GoalExaminer::plan(const Stop& stop, Examination& examination) const {
  auto refused = askRepertoire(stop);
  if (!refused) refused = askMap(stop);
  if (refused) {
    examination.report = *refused;
    return;
  }
  const auto planner = means_.repertoire.planner();
  PlanRequest request;
  request.world_from_start = examination.start;
  request.stop = stop;
  if (means_.obstacles) request.obstacles = means_.obstacles();
  request.goal_policy = means_.options.goalPolicy();
  examination.plan = planRoute(*planner, request, examination.goal.route());
  WalkReport& report = examination.report;
  report.code = codeOf(examination.plan.code);
  report.message = examination.plan.message;
  fillIn(examination.start, examination.plan, means_.options.pose.global_frame,
         means_.clock.rosNow(), report);
}

/// Through all waypoints, or to the first one that has no plan.
PlanResult GoalExaminer::planRoute(const AdaptivePlanner& planner, PlanRequest request,
                                   const std::vector<Waypoint>& route) const {
  request.stop = withinWallTime(means_.options, means_.clock, request.stop, route.size());
  RoutePlan plan = RoutePlanner(planner).plan(request, route);
  if (route.size() == 1) return plan.legs.front();
  PlanResult whole;
  for (std::size_t i = 0; i < plan.legs.size(); ++i) {
    PlanResult& leg = plan.legs[i];
    leg.message = ofWaypoint(i + 1, route.size()) + leg.message;
    if (!leg.success()) return leg;
    append(leg, whole);
  }
  return whole;
}

}  // namespace hexapod
