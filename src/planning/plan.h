#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "planning/obstacles.h"
#include "planning/planner_options.h"
#include "planning/way_field.h"

namespace hexapod {

/// What is done about a goal where the robot cannot stand.
enum class GoalPolicy {
  kRefuse,
  kNearest  ///< the nearest free pose that has a way is planned to instead
};

/// What one plan leaves for the next one to the same goal: its remaining steps and the ways around
/// the obstacles. Opaque to the caller, who hands it on from the PlanResult to the next request as
/// long as the robot does what was planned.
struct PlanMemory {
  std::vector<std::size_t> entries;  ///< indices in the repertoire
  bool is_begun = true;              ///< the first one was walked meanwhile
  double price = 0.0;                ///< of all of them
  double first_price = 0.0;          ///< of the first
  std::shared_ptr<const WayField> ways;
  std::shared_ptr<const WayField> bound;
  bool is_narrow = false;  ///< planned with ObstacleOptions::narrow_margin_m
};

/// A question to the planner. All poses are base_footprint in one common frame, here "world".
struct PlanRequest {
  Pose2 world_from_start;
  Pose2 world_from_goal;
  GoalTolerance tolerance;
  /// Optional: called now and then; planning ends soon after it first returns true, with the best
  /// plan so far if there is one: a clock or a cancelling user.
  std::function<bool()> stop;
  /// Optional: called with its number of behaviours at each better plan.
  std::function<void(std::size_t steps)> improved;
  /// Optional: where the robot may be.
  std::shared_ptr<const Obstacles> obstacles;
  GoalPolicy goal_policy = GoalPolicy::kRefuse;
  /// Of the last plan to this goal, after its first step was walked.
  PlanMemory memory;
  /// Optional: what each entry, by index, costs beside as the first behaviour, in behaviours.
  std::shared_ptr<const std::vector<double>> first_prices;
  /// Share of planning_time_s that may be spent.
  double effort = 1.0;
};

/// How planning ended. Only kFound and kAlreadyThere are successes.
enum class PlanCode {
  kFound,          ///< a chain of entries that each end where they are expected to leads there
  kAlreadyThere,   ///< the start is within tolerance: no steps
  kInvalidGoal,    ///< not finite, too far, impossible tolerance
  kNoRepertoire,   ///< no entry that may be planned with
  kUnreachable,    ///< no chain of entries was found that ends within tolerance
  kTimeout,        ///< planning_time_s used up, or stopped by the caller, before one was found
  kGoalOccupied,   ///< the footprint at the goal touches what is occupied
  kStartOccupied,  ///< the footprint at the start does
  kBlocked,        ///< proved: obstacles close every way
  kTooManySteps    ///< proved: more than max_steps behaviours are needed
};

/// "found", "already there", "invalid goal", "no repertoire", "unreachable", "timeout", "goal
/// occupied", "start occupied", "blocked", "too many steps".
std::string toString(PlanCode code);

/// One behaviour of a plan.
struct PlannedStep {
  std::size_t entry = 0;  ///< index in the repertoire
  std::int64_t id = 0;    ///< of the entry
  Pose2 world_from_end;   ///< predicted
};

/// A plan, or the reason why there is none.
struct PlanResult {
  PlanCode code = PlanCode::kNoRepertoire;
  std::string message;             ///< a sentence for the user
  std::vector<PlannedStep> steps;  ///< of a found plan
  /// What was planned to: the goal, or with GoalPolicy::kNearest the pose that stands for it.
  Pose2 world_from_target;
  /// Predicted end of the plan. Without one: the nearest end that was found, weighing distance and
  /// heading by their tolerances; with kBlocked and kGoalOccupied the nearest free pose that has a
  /// way, if there is one. Otherwise the start.
  Pose2 world_from_end;
  /// From that end to the target. More than the tolerance where a Foresight follows the chain and
  /// found none that leads nearer: a walk plans anew after each behaviour.
  double distance_m = 0.0;
  double heading_rad = 0.0;  ///< between that end and the target, 0 .. pi
  /// Expected root mean square error of the end if the plan were walked blindly. (Planned anew
  /// after each behaviour, little more than the last behaviour's own spread is left.)
  double spread_m = 0.0;
  double spread_rad = 0.0;
  /// Proved: no plan to the target has fewer behaviours that each end where they are expected to.
  std::size_t at_least_steps = 0;
  double length_m = 0.0;    ///< way of base_footprint along the plan
  double duration_s = 0.0;  ///< of its behaviours
  /// Smallest room between footprint with margin and what is occupied along the plan [m].
  double clearance_m = std::numeric_limits<double>::infinity();
  PlanMemory memory;
  /// What was spent of planning_time_s, as a share of it.
  double effort = 0.0;

  bool success() const { return code == PlanCode::kFound || code == PlanCode::kAlreadyThere; }
  /// By how much its end misses the target, as a share of the tolerance: up to 1 within.
  double shareMissed(const GoalTolerance& tolerance) const {
    const double turned = tolerance.anyHeading() ? 0.0 : heading_rad / tolerance.yaw_rad;
    return std::max(distance_m / tolerance.xy_m, turned);
  }
  /// Behaviours that a better plan may save at most.
  std::size_t gap() const { return steps.size() - std::min(steps.size(), at_least_steps); }
};

}  // namespace hexapod
