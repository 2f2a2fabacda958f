#include "planning/planner.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>
#include <stdexcept>

#include "planning/beam_search.h"

namespace hexapod {
namespace {

std::ostringstream sentence() {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(3);
  return out;
}

std::ostream& operator<<(std::ostream& out, const Pose2& pose) {
  return out << "(" << pose.x_m << " m, " << pose.y_m << " m, " << pose.yaw_rad << " rad)";
}

const PlannerOptions& checked(const PlannerOptions& options) {
  PlannerOptions copy = options;
  for (const Option& option : declareOptions(copy)) {
    const auto refuse = [&](double value) {
      if (value >= option.min && value <= option.max) return;
      std::ostringstream out = sentence();
      out << "Option " << option.name << " of the planner must be in " << option.range() << " "
          << option.unit << ", not " << value << ".";
      throw std::invalid_argument(out.str());
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
  std::ostringstream out = sentence();
  const GoalTolerance& tolerance = request.tolerance;
  const double far_m = distance(request.world_from_start, request.world_from_goal);
  if (!isFinite(request.world_from_goal)) {
    out << "The goal " << request.world_from_goal << " is not finite: give finite coordinates.";
  } else if (!isFinite(request.world_from_start)) {
    out << "The start " << request.world_from_start
        << " is not finite: the pose of the robot is not known.";
  } else if (!(tolerance.xy_m > 0.0) || !std::isfinite(tolerance.xy_m)) {
    out << "The xy tolerance must be a positive number of metres, not " << tolerance.xy_m << ".";
  } else if (!std::isfinite(tolerance.yaw_rad) || tolerance.yaw_rad == 0.0) {
    out << "The yaw tolerance must be positive, or negative for any heading [rad], not "
        << tolerance.yaw_rad << ".";
  } else if (!(far_m <= options.max_goal_distance_m)) {
    out << "The goal " << request.world_from_goal << " is " << far_m
        << " m away, farther than max_goal_distance_m = " << options.max_goal_distance_m
        << ": walk there by goals in between, or raise the option.";
  }
  return out.str();
}

bool arrived(const PlanResult& result, const GoalTolerance& tolerance) {
  return result.distance_m <= tolerance.xy_m &&
         (tolerance.anyHeading() || result.heading_rad <= tolerance.yaw_rad);
}

std::string noRepertoire(std::size_t entries) {
  std::ostringstream out = sentence();
  if (entries == 0) {
    out << "The repertoire has no entries: learn or load one first.";
  } else {
    out << "None of the " << entries
        << " entries of the repertoire can be planned with: each fell in its validation, does not "
           "move, or has no finite end pose. Learn another one.";
  }
  return out.str();
}

std::string describe(const PlanResult& result, const PlanRequest& request,
                     const PlannerOptions& options) {
  std::ostringstream out = sentence();
  switch (result.code) {
    case PlanCode::kFound:
      out << "Plan of " << result.steps.size()
          << (result.steps.size() == 1 ? " behaviour" : " behaviours") << ", predicted to end ";
      break;
    case PlanCode::kUnreachable:
      out << "No chain of at most " << options.max_steps << " behaviours was found to the goal "
          << request.world_from_goal << "; the nearest pose found is " << result.world_from_end
          << ", ";
      break;
    default:
      out << "No plan to the goal " << request.world_from_goal
          << " was found before planning was stopped or planning_time_s = "
          << options.planning_time_s << " was used up; the nearest pose found is "
          << result.world_from_end << ", ";
  }
  out << result.distance_m << " m and " << result.heading_rad << " rad from the goal.";
  return out.str();
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
