#include "planning/aim.h"

#include <cmath>
#include <optional>
#include <vector>

#include "planning/way_search.h"

namespace hexapod {
namespace {

constexpr int kDirections = 8;

/// Headings to try at a goal: its own, and others within the tolerance.
std::vector<double> headingsAt(const Pose2& goal, const GoalTolerance& tolerance) {
  std::vector<double> headings_rad = {goal.yaw_rad};
  if (!tolerance.anyHeading()) {
    headings_rad.push_back(goal.yaw_rad + tolerance.yaw_rad);
    headings_rad.push_back(goal.yaw_rad - tolerance.yaw_rad);
    return headings_rad;
  }
  for (int i = 1; i < kDirections; ++i) {
    headings_rad.push_back(goal.yaw_rad + 2.0 * M_PI / kDirections * i);
  }
  return headings_rad;
}

/// Whether the robot can stand at the goal, or beside it within the tolerance.
bool canStandAt(const Obstacles& obstacles, const Pose2& goal, const GoalTolerance& tolerance) {
  const std::vector<double> headings_rad = headingsAt(goal, tolerance);
  for (const double share : {0.0, 0.35, 0.7, 1.0}) {
    for (int i = 0; i < (share > 0.0 ? kDirections : 1); ++i) {
      const double direction_rad = 2.0 * M_PI / kDirections * i;
      const double off_m = share * tolerance.xy_m;
      const double x_m = goal.x_m + off_m * std::cos(direction_rad);
      const double y_m = goal.y_m + off_m * std::sin(direction_rad);
      for (const double heading_rad : headings_rad) {
        if (obstacles.isFree({x_m, y_m, heading_rad})) return true;
      }
    }
  }
  return false;
}

WayField::Question questionOf(const PlanRequest& request, const Pose2& target) {
  return {request.obstacles, request.world_from_start, target, request.tolerance.xy_m,
          request.stop};
}

/// Where the goal cannot be had: takes the nearest free pose that has a way for the target, if that
/// is wanted, and else tells it.
bool movesTarget(const PlanRequest& request, PlanResult& result, PlanCode code) {
  const std::optional<Pose2> nearest =
      nearestFreePose(questionOf(request, request.world_from_goal));
  const bool moved = distance(result.world_from_target, request.world_from_goal) > 0.0;
  if (request.goal_policy == GoalPolicy::kNearest && nearest && !moved) {
    result.world_from_target = *nearest;
    measureTo(request.world_from_start, result);
    if (!isWithin(request.tolerance, result)) return true;
    result.code = PlanCode::kAlreadyThere;
    return false;
  }
  result.code = code;
  if (nearest) measureTo(*nearest, result);
  return false;
}

/// Whether there is a way to the target, or to what is nearest to it.
bool findsWays(const PlanRequest& request, PlanResult& result) {
  const WayField::Question question = questionOf(request, result.world_from_target);
  const PlanMemory& memory = request.memory;
  if (memory.ways && memory.ways->answers(question)) {
    result.memory.ways = memory.ways;
    result.memory.bound = memory.bound;
    return true;
  }
  WaySearch found = findWays(question);
  if (found.cut_short) {
    result.code = PlanCode::kTimeout;
    return false;
  }
  result.memory.ways = found.ways;
  result.memory.bound = found.bound;
  if (!found.blocked) return true;
  return movesTarget(request, result, PlanCode::kBlocked) && findsWays(request, result);
}

}  // namespace

bool aim(const PlanRequest& request, PlanResult& result) {
  const Obstacles& obstacles = *request.obstacles;
  if (obstacles.clearance_m(request.world_from_start) < -obstacles.options().footprint_margin_m) {
    result.code = PlanCode::kStartOccupied;
    return false;
  }
  if (canStandAt(obstacles, request.world_from_goal, request.tolerance)) {
    return findsWays(request, result);
  }
  return movesTarget(request, result, PlanCode::kGoalOccupied) && findsWays(request, result);
}

void measureTo(const Pose2& world_from_end, PlanResult& result) {
  result.world_from_end = world_from_end;
  result.distance_m = distance(world_from_end, result.world_from_target);
  result.heading_rad = headingDistance(world_from_end, result.world_from_target);
}

bool isWithin(const GoalTolerance& tolerance, const PlanResult& result) {
  return result.distance_m <= tolerance.xy_m &&
         (tolerance.anyHeading() || result.heading_rad <= tolerance.yaw_rad);
}

}  // namespace hexapod
