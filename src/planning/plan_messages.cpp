#include "planning/plan_messages.h"

#include <cmath>

#include "common/text.h"
#include "geometry/pose2.h"

namespace hexapod {
namespace {

// Poses nearer to each other differ by rounding only.
constexpr double kSame_m = 1e-9;

std::string text(double number) { return numberText(number, 3); }

/// Why there is no plan, up to the nearest pose.
std::string describeFailure(const PlanResult& result, const PlanRequest& request,
                            const PlannerOptions& options) {
  const std::string goal = "the goal " + poseText(request.world_from_goal);
  const std::string target = "the goal " + poseText(result.world_from_target);
  switch (result.code) {
    case PlanCode::kGoalOccupied:
      return "The robot cannot stand at " + goal + ": with its margin it would touch an obstacle";
    case PlanCode::kStartOccupied:
      return "The robot stands at " + poseText(request.world_from_start) +
             " within an obstacle of the map: check the map and the pose, or move the robot away";
    case PlanCode::kBlocked:
      return "Obstacles close every way to " + goal;
    case PlanCode::kTooManySteps:
      return "The goal " + poseText(result.world_from_target) + " takes at least " +
             std::to_string(result.at_least_steps) +
             " behaviours, more than max_steps = " + std::to_string(options.max_steps);
    case PlanCode::kUnreachable:
      return "No chain of at most " + std::to_string(options.max_steps) +
             " behaviours was found to " + target;
    default:
      return "No plan to " + target +
             " was found before planning was stopped, by a cancel or the clock, or "
             "planning_time_s = " +
             text(options.planning_time_s) + " was used up";
  }
}

/// "Plan of 3 behaviours", and what is proved of their number where it is one that arrives.
std::string describeLength(const PlanResult& result, bool arrives) {
  const std::size_t steps = result.steps.size();
  std::string plan =
      "Plan of " + std::to_string(steps) + (steps == 1 ? " behaviour" : " behaviours");
  if (!arrives) return plan;
  return plan + (result.gap() == 0
                     ? " (no plan has fewer)"
                     : " (at least " + std::to_string(result.at_least_steps) + " are needed)");
}

/// "1.2 m in 11.7 s", and the room it keeps among obstacles.
std::string describeWay(const PlanResult& result, const PlanRequest& request) {
  std::string way = text(result.length_m) + " m in " + text(result.duration_s) + " s";
  if (std::isfinite(result.clearance_m)) {
    const bool is_narrow = request.obstacles && !request.obstacles->narrow();
    way += " keeping " + text(result.clearance_m) + " m beyond the " +
           (is_narrow ? "margin of narrow passages" : "margin");
  }
  return way;
}

}  // namespace

std::string toString(PlanCode code) {
  switch (code) {
    case PlanCode::kFound:
      return "found";
    case PlanCode::kAlreadyThere:
      return "already there";
    case PlanCode::kInvalidGoal:
      return "invalid goal";
    case PlanCode::kNoRepertoire:
      return "no repertoire";
    case PlanCode::kUnreachable:
      return "unreachable";
    case PlanCode::kTimeout:
      return "timeout";
    case PlanCode::kGoalOccupied:
      return "goal occupied";
    case PlanCode::kStartOccupied:
      return "start occupied";
    case PlanCode::kBlocked:
      return "blocked";
    case PlanCode::kTooManySteps:
      return "too many steps";
  }
  return "unknown";
}

std::string whyInvalid(const PlanRequest& request, const PlannerOptions& options) {
  const GoalTolerance& tolerance = request.tolerance;
  const double far_m = distance(request.world_from_start, request.world_from_goal);
  if (!isFinite(request.world_from_goal)) {
    return "The goal " + poseText(request.world_from_goal) +
           " is not finite: give finite coordinates.";
  }
  if (!isFinite(request.world_from_start)) {
    return "The start " + poseText(request.world_from_start) +
           " is not finite: the pose of the robot is not known.";
  }
  if (!(tolerance.xy_m > 0.0) || !std::isfinite(tolerance.xy_m)) {
    return "The xy tolerance must be a positive number of metres, not " + text(tolerance.xy_m) +
           ".";
  }
  if (!std::isfinite(tolerance.yaw_rad) || tolerance.yaw_rad == 0.0) {
    return "The yaw tolerance must be positive, or negative for any heading [rad], not " +
           text(tolerance.yaw_rad) + ".";
  }
  if (far_m <= options.max_goal_distance_m) return "";
  return "The goal " + poseText(request.world_from_goal) + " is " + text(far_m) +
         " m away, farther than max_goal_distance_m = " + text(options.max_goal_distance_m) +
         ": walk there by goals in between, or raise the option.";
}

std::string noRepertoire(std::size_t entries) {
  if (entries == 0) return "The repertoire has no entries: learn or load one first.";
  return "None of the " + std::to_string(entries) +
         " entries of the repertoire can be planned with: each fell in its validation, does not "
         "move, or has no finite end pose. Learn another one.";
}

std::string nothingWalks(std::size_t entries) {
  return "None of the " + std::to_string(entries) +
         " entries of the repertoire is expected to walk any more, with the body that the robot is "
         "believed to have (topic body_belief). Stand it up and repair it, and where the belief is "
         "wrong then, call ~reset_belief of the planner.";
}

std::string describe(const PlanResult& result, const PlanRequest& request,
                     const PlannerOptions& options) {
  if (result.code == PlanCode::kAlreadyThere) {
    return "The goal is within tolerance of the start: no behaviour is needed.";
  }
  std::string end =
      text(result.distance_m) + " m and " + text(result.heading_rad / kDegree) + " deg from ";
  if (distance(result.world_from_target, request.world_from_goal) > kSame_m) {
    end += poseText(result.world_from_target) + ", the nearest free pose to ";
  }
  end += "the goal";
  if (result.code == PlanCode::kFound) {
    const bool arrives = result.shareMissed(request.tolerance) <= 1.0;
    return describeLength(result, arrives) + ", " + describeWay(result, request) +
           ", predicted to end " + end +
           (arrives ? "."
                    : ", outside of the tolerance: of the body that the robot is believed to have "
                      "no chain was found that leads nearer, and a walk plans anew after each "
                      "behaviour.");
  }
  return describeFailure(result, request, options) + "; the nearest pose found is " +
         poseText(result.world_from_end) + ", " + end + ".";
}

}  // namespace hexapod
