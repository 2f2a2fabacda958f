#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "planning/planner_options.h"
#include "planning/planning_tables.h"

namespace hexapod {

/// A question to the planner. All poses are base_footprint in one common frame, here "world".
struct PlanRequest {
  Pose2 world_from_start;
  Pose2 world_from_goal;
  GoalTolerance tolerance;
  /// Optional: called now and then; planning ends soon after it first returns true.
  std::function<bool()> stop;
  /// Optional: false where base_footprint may not be. Asked every 2 cm along the arcs; the start is
  /// not asked.
  std::function<bool(const Pose2&)> is_free;
};

/// How planning ended. Only kFound and kAlreadyThere are successes.
enum class PlanCode {
  kFound,
  kAlreadyThere,  ///< the start is within tolerance: no steps
  kInvalidGoal,   ///< not finite, too far, impossible tolerance
  kNoRepertoire,  ///< no entry that may be planned with
  kUnreachable,   ///< no chain of entries ends within tolerance
  kTimeout        ///< planning_time_s used up, or stopped by the caller, before one was found
};

/// "found", "already there", "invalid goal", "no repertoire", "unreachable", "timeout".
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
  /// Predicted end of the plan. kUnreachable and kTimeout: the nearest end that was found, weighing
  /// distance and heading by their tolerances. Otherwise the start.
  Pose2 world_from_end;
  double distance_m = 0.0;   ///< from that end to the goal
  double heading_rad = 0.0;  ///< between that end and the goal, 0 .. pi
  /// Expected root mean square error of the end if the plan were walked blindly. (Planned anew
  /// after each behaviour, little more than the last behaviour's own spread is left.)
  double spread_m = 0.0;
  double spread_rad = 0.0;

  bool success() const { return code == PlanCode::kFound || code == PlanCode::kAlreadyThere; }
};

/// Chains repertoire entries from a start pose to a goal pose.
///
/// Promises: a found plan's composed expected poses end within tolerance; only entries that are
/// steady (SteadinessOptions), move and have finite poses take part; all plans of one and two
/// behaviours are weighed (within a tolerance of up to 0.15 m and 0.35 rad), longer ones by a
/// bounded search (BeamSearch).
/// The plan of least expected behaviours is returned: its number, plus the price of
/// unsure entries and of the chance to end outside the tolerance (EndCost). A longer plan never
/// wins against a shorter one unless spreads make the shorter one unsure. Plan anew from the
/// measured pose after each behaviour.
///
/// The work is bounded by a count derived from planning_time_s, not by a clock: the same start,
/// goal and repertoire always give the same plan, unless `stop` interferes. Immutable; plan() may
/// be called from several threads at once. Construction takes some 50 ms.
class Planner {
 public:
  /// Copies what it needs from the repertoire. Throws std::invalid_argument naming the option when
  /// one is out of the range that declareOptions() states. With a `deviation` the entries are
  /// expected to lead where it says.
  Planner(const Repertoire& repertoire, const PlannerOptions& options,
          const Deviation& deviation = {});

  PlanResult plan(const PlanRequest& request) const;

  /// Entries that take part in planning.
  std::size_t usableEntries() const { return tables_.moves.size(); }

  /// How far the farthest of them leads [m]; 0 when there is none.
  double reach_m() const;

 private:
  void search(const PlanRequest& request, PlanResult& result) const;

  PlannerOptions options_;
  PlanningTables tables_;
  std::vector<std::int64_t> ids_;  ///< per entry of the repertoire
};

}  // namespace hexapod
