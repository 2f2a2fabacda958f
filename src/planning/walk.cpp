#include "planning/walk.h"

#include <algorithm>
#include <cmath>

namespace hexapod {
namespace {

// Smaller deviations are the ordinary spread of a behaviour, whatever share of its length they are.
constexpr double kOrdinaryDeviation_m = 0.06;

// So many waypoints are planned through before each behaviour: what comes after them hardly changes
// the next one, and the robot stands meanwhile.
constexpr std::ptrdiff_t kAhead = 8;

}  // namespace

Walk::Walk(std::shared_ptr<AdaptivePlanner> planner, const Pose2& world_from_goal,
           const GoalTolerance& tolerance, const WalkOptions& options)
    : Walk(std::move(planner), {{world_from_goal, tolerance}}, options) {}

Walk::Walk(std::shared_ptr<AdaptivePlanner> planner, std::vector<Waypoint> route,
           const WalkOptions& options)
    : planner_(std::move(planner)), route_(std::move(route)), options_(options) {}

std::optional<std::string> Walk::problemWith(const Pose2& world_from_robot, WalkState& state) {
  if (!expected_) return std::nullopt;
  const double moved = distance(before_, world_from_robot);
  const double deviation = behaviorGap_m(expected_->world_from_end, world_from_robot);
  if (moved > options_.jump_reaches * planner_->reach_m()) {
    state = WalkState::kPoseLost;
    return "The measured pose jumped from " + poseText(before_) + " to " +
           poseText(world_from_robot) +
           " within one behaviour. Check the odometry and send the goal again.";
  }
  const double predicted = behaviorGap_m(before_, expected_->world_from_end);
  const bool failed =
      deviation > kOrdinaryDeviation_m && deviation > options_.failed_share * predicted;
  failed_in_a_row_ = failed ? failed_in_a_row_ + 1 : 0;
  if (failed_in_a_row_ < options_.max_failed_steps && steps_taken_ < most_steps_) {
    return std::nullopt;
  }
  state = WalkState::kStuck;
  const std::string why = failed_in_a_row_ >= options_.max_failed_steps
                              ? "the last " + std::to_string(failed_in_a_row_) +
                                    " behaviours ended far from their "
                                    "prediction, the last one predicted " +
                                    poseText(expected_->world_from_end) + " and measured " +
                                    poseText(world_from_robot)
                              : std::to_string(steps_taken_) + " behaviours did not lead there";
  return "Stuck on the way to " + poseText(route_[at_].world_from_goal) + ": " + why +
         ". Free the robot, or check that the repertoire was learned for it.";
}

bool Walk::isAt(const Waypoint& waypoint, const Pose2& world_from_robot) const {
  const GoalTolerance& tolerance = waypoint.tolerance;
  return distance(world_from_robot, waypoint.world_from_goal) <= tolerance.xy_m &&
         (tolerance.anyHeading() ||
          headingDistance(world_from_robot, waypoint.world_from_goal) <= tolerance.yaw_rad);
}

/// The next waypoint is walked to.
void Walk::pass() {
  ++at_;
  most_steps_ = kUnknown;
  memory_.pass();
}

/// The plan to the first waypoint that the robot is not at yet, with a view to all after it.
PlanResult Walk::planOnward(const PlanRequest& request) {
  while (at_ + 1 < route_.size() && isAt(route_[at_], request.world_from_start)) pass();
  const auto from = route_.begin() + static_cast<std::ptrdiff_t>(at_);
  const std::vector<Waypoint> ahead(from, from + std::min(kAhead, route_.end() - from));
  RoutePlan plan = RoutePlanner(*planner_).plan(request, ahead, memory_);
  memory_ = std::move(plan.memory);
  // The nearest free pose that stands for a waypoint may be where the robot stands.
  std::size_t leg = 0;
  for (; plan.legs[leg].code == PlanCode::kAlreadyThere && leg + 1 < plan.legs.size(); ++leg)
    pass();
  memory_.begin();
  return plan.legs[leg];
}

std::string Walk::describeArrival(const Pose2& world_from_robot, const PlanResult& plan) const {
  const Pose2& goal = route_.back().world_from_goal;
  std::string text = "Arrived at " + poseText(world_from_robot) + " after " +
                     std::to_string(steps_taken_) +
                     (steps_taken_ == 1 ? " behaviour" : " behaviours");
  if (route_.size() > 1) text += " through " + std::to_string(route_.size()) + " waypoints";
  if (distance(plan.world_from_target, goal) > 0.0) {
    text += ", the nearest free pose to the goal " + poseText(goal);
  }
  return text + ".";
}

Walk::Decision Walk::decide(const Pose2& world_from_robot, const std::function<bool()>& stop) {
  Decision decision;
  if (expected_) {
    planner_->observe(expected_->entry, before_, world_from_robot, joints_);
  }
  joints_.clear();
  PlanRequest request;
  request.world_from_start = world_from_robot;
  request.stop = stop;
  request.obstacles = obstacles_;
  request.goal_policy = options_.goal_policy;
  decision.plan = planOnward(request);
  decision.waypoint = at_;
  decision.message = decision.plan.message;
  if (decision.plan.code == PlanCode::kAlreadyThere) {
    decision.state = WalkState::kArrived;
    decision.message = describeArrival(world_from_robot, decision.plan);
    return decision;
  }
  if (const auto problem = problemWith(world_from_robot, decision.state)) {
    decision.message = *problem;
    return decision;
  }
  if (decision.plan.code != PlanCode::kFound) return decision;
  if (most_steps_ == kUnknown) {
    const auto steps = static_cast<std::int64_t>(decision.plan.steps.size());
    most_steps_ = steps_taken_ + options_.max_steps_factor * steps + 10;
  }
  decision.state = WalkState::kStep;
  decision.step = decision.plan.steps.front();
  expected_ = decision.step;
  before_ = world_from_robot;
  ++steps_taken_;
  return decision;
}

}  // namespace hexapod
