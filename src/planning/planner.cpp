#include "planning/planner.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/text.h"
#include "planning/aim.h"
#include "planning/beam_search.h"
#include "planning/plan_messages.h"

namespace hexapod {
namespace {

const PlannerOptions& checked(const PlannerOptions& options) {
  PlannerOptions copy = options;
  for (const Option& option : declareOptions(copy)) {
    const auto refuse = [&](double value) {
      if (value >= option.min && value <= option.max) return;
      throw std::invalid_argument("Option " + option.name + " of the planner must be in " +
                                  option.range() + ", not " + numberText(value, 3) + ".");
    };
    if (const auto* number = std::get_if<double*>(&option.target)) refuse(**number);
    if (const auto* count = std::get_if<std::int64_t*>(&option.target)) {
      refuse(static_cast<double>(**count));
    }
  }
  return options;
}

// Nearly all plans that there are with the whole margin are found with so much of the effort.
constexpr double kWideEffort = 0.2;

/// Whether a narrower margin may help.
bool mayBeNarrow(PlanCode code) {
  return code == PlanCode::kGoalOccupied || code == PlanCode::kBlocked ||
         code == PlanCode::kUnreachable || code == PlanCode::kTimeout;
}

}  // namespace

Planner::Planner(const Repertoire& repertoire, const PlannerOptions& options,
                 const EntryPaths& paths)
    : options_(checked(options)),
      tables_(repertoire, options_, paths),
      behavior_duration_s_(repertoire.behavior_duration_s),
      move_of_(repertoire.entries.size(), kNone) {
  ids_.reserve(repertoire.entries.size());
  for (const Entry& entry : repertoire.entries) ids_.push_back(entry.id);
  for (std::size_t i = 0; i < tables_.moves.size(); ++i) move_of_[tables_.moves[i].entry] = i;
}

PlanResult Planner::plan(const PlanRequest& request) const {
  if (!request.obstacles || !request.obstacles->narrow()) return planAmong(request);
  PlanRequest wide = request;
  wide.goal_policy = GoalPolicy::kRefuse;
  PlanRequest narrow = wide;
  narrow.obstacles = request.obstacles->narrow();
  wide.effort *= kWideEffort;
  double effort = 0.0;
  // A newer map may leave more room.
  const PlanMemory& memory = request.memory;
  if (!memory.is_narrow || !memory.ways || !memory.ways->isAmong(narrow.obstacles)) {
    PlanResult result = planAmong(wide);
    if (!mayBeNarrow(result.code) || (request.stop && request.stop())) return result;
    effort = result.effort;
  }
  PlanResult result = planAmong(narrow);
  result.memory.is_narrow = true;
  effort += result.effort;
  if (request.goal_policy == GoalPolicy::kNearest && !result.success()) {
    result = planAmong(request);
    effort += result.effort;
  }
  result.effort = effort;
  return result;
}

/// With the margin of the request's obstacles.
PlanResult Planner::planAmong(const PlanRequest& request) const {
  PlanResult result;
  result.world_from_target = request.world_from_goal;
  result.world_from_end = request.world_from_start;
  result.message = whyInvalid(request, options_);
  if (!result.message.empty()) {
    result.code = PlanCode::kInvalidGoal;
    return result;
  }
  measureTo(request.world_from_start, result);
  if (isWithin(request.tolerance, result)) {
    result.code = PlanCode::kAlreadyThere;
  } else if (tables_.moves.empty()) {
    result.code = PlanCode::kNoRepertoire;
    result.message = noRepertoire(ids_.size());
    return result;
  } else if (!request.obstacles || aim(request, result)) {
    search(request, result);
  }
  result.message = describe(result, request, options_);
  return result;
}

std::vector<std::size_t> Planner::entries() const {
  std::vector<std::size_t> entries;
  for (const Move& move : tables_.moves) entries.push_back(move.entry);
  return entries;
}

double Planner::turn_rad() const {
  double turn_rad = 0.0;
  for (const Move& move : tables_.moves) turn_rad = std::max(turn_rad, std::abs(move.end.yaw_rad));
  return turn_rad;
}

double behaviorGap_m(const Pose2& a, const Pose2& b) {
  return distance(a, b) + kMetresPerRadian * headingDistance(a, b);
}

std::optional<PlannedStep> Planner::nearestStep(const Pose2& start_from_end) const {
  const auto nearest = std::min_element(
      tables_.moves.begin(), tables_.moves.end(), [&](const Move& a, const Move& b) {
        return behaviorGap_m(a.end, start_from_end) < behaviorGap_m(b.end, start_from_end);
      });
  if (nearest == tables_.moves.end()) return std::nullopt;
  return PlannedStep{nearest->entry, ids_[nearest->entry], nearest->end};
}

bool Planner::isFree(const Obstacles& obstacles, const Pose2& world_from_start,
                     std::size_t entry) const {
  return obstacles.isFree(world_from_start, tables_.moves.at(move_of_.at(entry)).path,
                          std::min(0.0, obstacles.clearance_m(world_from_start)));
}

void Planner::search(const PlanRequest& request, PlanResult& result) const {
  const SearchProblem problem = problemOf(request, result);
  const SearchResult found =
      BeamSearch(tables_, options_, problem, boundOf(problem, result.memory.bound.get())).run();
  compose(found.chain, problem.obstacles, result);
  measureTo(result.world_from_end, result);
  result.at_least_steps = static_cast<std::size_t>(found.at_least);
  result.effort = found.spent_s / options_.planning_time_s;
  if (found.found) {
    result.code = PlanCode::kFound;
    result.memory.price = found.price;
    const std::size_t first = found.chain.front();
    result.memory.first_price = tables_.moves[first].cost;
    if (!problem.first_prices.empty()) result.memory.first_price += problem.first_prices[first];
    return;
  }
  result.steps.clear();
  result.length_m = result.duration_s = 0.0;
  result.memory.entries.clear();
  result.code = found.at_least > options_.max_steps ? PlanCode::kTooManySteps
                : found.exhausted                   ? PlanCode::kUnreachable
                                                    : PlanCode::kTimeout;
}

SearchProblem Planner::problemOf(const PlanRequest& request, const PlanResult& result) const {
  SearchProblem problem;
  problem.world_from_start = request.world_from_start;
  problem.world_from_goal = result.world_from_target;
  problem.tolerance = request.tolerance;
  problem.stop = request.stop;
  problem.improved = request.improved;
  problem.effort = request.effort;
  problem.obstacles = request.obstacles.get();
  problem.ways = result.memory.ways.get();
  if (request.obstacles) {
    problem.least_clearance_m =
        std::min(0.0, request.obstacles->clearance_m(request.world_from_start));
  }
  if (request.first_prices) {
    for (const Move& move : tables_.moves) {
      problem.first_prices.push_back(request.first_prices->at(move.entry));
    }
  }
  const PlanMemory& memory = request.memory;
  for (std::size_t i = memory.is_begun ? 1 : 0; i < memory.entries.size(); ++i) {
    const std::size_t entry = memory.entries[i];
    const std::size_t move = entry < move_of_.size() ? move_of_[entry] : kNone;
    if (move == kNone) {
      problem.earlier.clear();
      break;
    }
    problem.earlier.push_back(move);
  }
  problem.earlier_price = memory.price - (memory.is_begun ? memory.first_price : 0.0);
  return problem;
}

double Planner::stepsToGo(const Pose2& world_from_start, const Pose2& world_from_goal,
                          bool any_heading, const WayField* ways) const {
  const Pose2 start_from_goal = inverse(world_from_start) * world_from_goal;
  if (!ways) return tables_.steps_to_go(start_from_goal, any_heading);
  return tables_.steps_to_go(*ways, world_from_start, start_from_goal.yaw_rad, any_heading);
}

/// Behaviours at least, before any search.
int Planner::boundOf(const SearchProblem& problem, const WayField* bound_of_ways) const {
  const StepsBound& bound = tables_.steps_bound;
  const int steps =
      bound(inverse(problem.world_from_start) * problem.world_from_goal, problem.tolerance);
  if (!bound_of_ways) return steps;
  const double way_m =
      bound_of_ways->atLeast_m(problem.world_from_start.x_m, problem.world_from_start.y_m);
  return std::max(steps, static_cast<int>(std::ceil((way_m - 1e-9) / bound.longest_path_m())));
}

/// Fills in the steps of a chain, where they lead, and the room along them.
void Planner::compose(const std::vector<std::size_t>& chain, const Obstacles* obstacles,
                      PlanResult& result) const {
  Uncertainty uncertainty;
  for (const std::size_t index : chain) {
    const Move& move = tables_.moves[index];
    if (obstacles) {
      result.clearance_m =
          std::min(result.clearance_m, obstacles->clearance_m(result.world_from_end, move.path));
    }
    result.world_from_end = result.world_from_end * move.end;
    result.length_m += move.path.points.back().moved_m;
    result.duration_s += behavior_duration_s_;
    uncertainty = uncertainty.after(move, 1.0);
    result.steps.push_back({move.entry, ids_[move.entry], result.world_from_end});
    result.memory.entries.push_back(move.entry);
  }
  result.spread_m = std::sqrt(uncertainty.position_m2);
  result.spread_rad = std::sqrt(uncertainty.heading_rad2);
}

double Planner::clearance_m(const Obstacles& obstacles, const Pose2& world_from_start,
                            std::size_t entry) const {
  return obstacles.clearance_m(world_from_start, tables_.moves.at(move_of_.at(entry)).path);
}

}  // namespace hexapod
