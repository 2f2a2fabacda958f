#include "planning/planner.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/text.h"
#include "planning/beam_search.h"

namespace hexapod {
namespace {

std::string text(double number) { return numberText(number, 3); }

const PlannerOptions& checked(const PlannerOptions& options) {
  PlannerOptions copy = options;
  for (const Option& option : declareOptions(copy)) {
    const auto refuse = [&](double value) {
      if (value >= option.min && value <= option.max) return;
      throw std::invalid_argument("Option " + option.name + " of the planner must be in " +
                                  option.range() + ", not " + text(value) + ".");
    };
    if (const auto* number = std::get_if<double*>(&option.target)) refuse(**number);
    if (const auto* count = std::get_if<std::int64_t*>(&option.target)) {
      refuse(static_cast<double>(**count));
    }
  }
  return options;
}

/// Empty when the request can be answered.
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

bool arrived(const PlanResult& result, const GoalTolerance& tolerance) {
  return result.distance_m <= tolerance.xy_m &&
         (tolerance.anyHeading() || result.heading_rad <= tolerance.yaw_rad);
}

std::string noRepertoire(std::size_t entries) {
  if (entries == 0) return "The repertoire has no entries: learn or load one first.";
  return "None of the " + std::to_string(entries) +
         " entries of the repertoire can be planned with: each fell in its validation, does not "
         "move, or has no finite end pose. Learn another one.";
}

std::string describe(const PlanResult& result, const PlanRequest& request,
                     const PlannerOptions& options) {
  const std::string end = text(result.distance_m) + " m and " +
                          text(result.heading_rad * 180.0 / M_PI) + " deg from the goal.";
  if (result.code == PlanCode::kFound) {
    return "Plan of " + std::to_string(result.steps.size()) +
           (result.steps.size() == 1 ? " behaviour" : " behaviours") + ", predicted to end " + end;
  }
  const std::string goal = "the goal " + poseText(request.world_from_goal);
  const std::string nearest =
      "; the nearest pose found is " + poseText(result.world_from_end) + ", " + end;
  if (result.code == PlanCode::kUnreachable) {
    return "No chain of at most " + std::to_string(options.max_steps) +
           " behaviours was found to " + goal + nearest;
  }
  return "No plan to " + goal + " was found before planning was stopped or planning_time_s = " +
         text(options.planning_time_s) + " was used up" + nearest;
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
  }
  return "unknown";
}

Planner::Planner(const Repertoire& repertoire, const PlannerOptions& options,
                 const Deviation& deviation)
    : options_(checked(options)), tables_(repertoire, options_, deviation) {
  ids_.reserve(repertoire.entries.size());
  for (const Entry& entry : repertoire.entries) ids_.push_back(entry.id);
}

PlanResult Planner::plan(const PlanRequest& request) const {
  PlanResult result;
  result.world_from_end = request.world_from_start;
  result.message = whyInvalid(request, options_);
  if (!result.message.empty()) {
    result.code = PlanCode::kInvalidGoal;
    return result;
  }
  result.distance_m = distance(request.world_from_start, request.world_from_goal);
  result.heading_rad = headingDistance(request.world_from_start, request.world_from_goal);
  if (arrived(result, request.tolerance)) {
    result.code = PlanCode::kAlreadyThere;
    result.message = "The goal is within tolerance of the start: no behaviour is needed.";
  } else if (tables_.moves.empty()) {
    result.code = PlanCode::kNoRepertoire;
    result.message = noRepertoire(ids_.size());
  } else {
    search(request, result);
    result.message = describe(result, request, options_);
  }
  return result;
}

double Planner::reach_m() const {
  double reach_m = 0.0;
  for (const Move& move : tables_.moves) reach_m = std::max(reach_m, move.length_m);
  return reach_m;
}

void Planner::search(const PlanRequest& request, PlanResult& result) const {
  BeamSearch::Problem problem{inverse(request.world_from_start) * request.world_from_goal,
                              request.tolerance,
                              request.stop,
                              {}};
  if (request.is_free) {
    problem.is_free = [&request](const Pose2& start_from_robot) {
      return request.is_free(request.world_from_start * start_from_robot);
    };
  }
  const SearchResult found = BeamSearch(tables_, options_, problem).run();
  Uncertainty uncertainty;
  for (const std::size_t index : found.chain) {
    const Move& move = tables_.moves[index];
    result.world_from_end = result.world_from_end * move.end;
    uncertainty = uncertainty.after(move, 1.0);
    if (found.found) result.steps.push_back({move.entry, ids_[move.entry], result.world_from_end});
  }
  result.distance_m = distance(result.world_from_end, request.world_from_goal);
  result.heading_rad = headingDistance(result.world_from_end, request.world_from_goal);
  result.spread_m = std::sqrt(uncertainty.position_m2);
  result.spread_rad = std::sqrt(uncertainty.heading_rad2);
  result.code = found.found       ? PlanCode::kFound
                : found.exhausted ? PlanCode::kUnreachable
                                  : PlanCode::kTimeout;
}

}  // namespace hexapod
