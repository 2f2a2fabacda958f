#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "planning/chain_tree.h"
#include "planning/plan.h"
#include "planning/planning_tables.h"

namespace hexapod {

/// Chains repertoire entries from a start pose to a goal pose.
///
/// Promises: a found plan's composed expected poses end within tolerance; along their paths the
/// footprint with its margin touches nothing occupied (where the start is within the margin, the
/// first move comes no nearer); only entries that are steady (SteadinessOptions), move and have
/// finite poses take part; all plans of one and two behaviours are weighed (within a tolerance of
/// up to 0.15 m and 0.35 rad), longer ones by a bounded search (BeamSearch). The plan of least
/// expected behaviours is returned: its number, plus the price of unsure entries and of the chance
/// to end outside the tolerance (EndCost). A longer plan never wins against a shorter one unless
/// spreads make the shorter one unsure. Every answer says how many behaviours are needed at least.
/// Plan anew from the measured pose after each behaviour, with the memory of the plan before.
///
/// The work is bounded by a count derived from planning_time_s, not by a clock: the same start,
/// goal and repertoire always give the same plan, unless `stop` interferes. Immutable; plan() may
/// be called from several threads at once. Construction takes some 50 ms.
class Planner {
 public:
  /// Copies what it needs from the repertoire. Throws std::invalid_argument naming the option when
  /// one is out of the range that declareOptions() states. Entries lead along `paths`, by index,
  /// where those are known.
  Planner(const Repertoire& repertoire, const PlannerOptions& options,
          const EntryPaths& paths = {});

  /// Where the obstacles with their margin leave no plan, one with their narrow margin.
  PlanResult plan(const PlanRequest& request) const;

  /// Room along a behaviour that begins at a pose [m], as PlanResult::clearance_m; negative: it
  /// would touch. The entry, by index, must take part in planning.
  double clearance_m(const Obstacles& obstacles, const Pose2& world_from_start,
                     std::size_t entry) const;

  /// Whether that behaviour surely touches nothing; where the start is within the margin, whether
  /// it comes no nearer.
  bool isFree(const Obstacles& obstacles, const Pose2& world_from_start, std::size_t entry) const;

  /// Entries that take part in planning: how many, and their indices.
  /// @{
  std::size_t usableEntries() const { return tables_.moves.size(); }
  std::vector<std::size_t> entries() const;
  /// @}

  /// How far the farthest of them leads [m], and the largest heading change [rad]; 0 when there is
  /// none.
  /// @{
  double reach_m() const { return tables_.steps_bound.longest_m(); }
  double turn_rad() const;
  /// @}

  /// Rough number of behaviours to a goal, along `ways` to it, which may be null: StepsToGo.
  double stepsToGo(const Pose2& world_from_start, const Pose2& world_from_goal, bool any_heading,
                   const WayField* ways) const;

  /// The one that leads nearest to `start_from_end` by behaviorGap_m(); its end in the frame of the
  /// start. Nothing when there is none.
  std::optional<PlannedStep> nearestStep(const Pose2& start_from_end) const;

 private:
  PlanResult planAmong(const PlanRequest& request) const;
  void search(const PlanRequest& request, PlanResult& result) const;
  SearchProblem problemOf(const PlanRequest& request, const PlanResult& result) const;
  int boundOf(const SearchProblem& problem, const WayField* bound) const;
  void compose(const std::vector<std::size_t>& chain, const Obstacles* obstacles,
               PlanResult& result) const;

  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  PlannerOptions options_;
  PlanningTables tables_;
  double behavior_duration_s_;
  std::vector<std::int64_t> ids_;     ///< per entry of the repertoire
  std::vector<std::size_t> move_of_;  ///< per entry; kNone: takes no part
};

/// How far apart two ends of a behaviour are [m], a radian counting as kMetresPerRadian.
double behaviorGap_m(const Pose2& a, const Pose2& b);

}  // namespace hexapod
