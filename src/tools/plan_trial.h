#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "common/random.h"
#include "planning/planner.h"
#include "tools/made_worlds.h"

namespace hexapod {

/// A question of the benchmark, in a world or in none.
struct PlanTask {
  std::shared_ptr<const OccupancyMap> map;
  PlanRequest request;
};

/// Planning again after the first behaviour, in processor time.
struct Replan {
  double afresh_s = 0.0;   ///< without memory
  double again_s = 0.0;    ///< with the memory of the plan
  bool succeeded = false;  ///< there was a second behaviour to plan for, and both did
};

/// One answer and what it took, in processor time.
struct PlanTrial {
  PlanResult plan;
  double first_s = 0.0;  ///< until there was a plan
  double whole_s = 0.0;  ///< until the end
  Replan predicted;      ///< where the first behaviour ends as predicted
  Replan missed;         ///< and somewhat beside that (drawMiss())
  double touch_m = 0.0;  ///< room beside the footprint that TouchCheck sees; negative: it touches
};

/// Goals in a square of 4 m around the start, any heading.
std::vector<PlanTask> tasksInTheEmpty(std::size_t count, const GoalTolerance& tolerance,
                                      std::uint64_t seed);

/// Starts and goals in ten worlds of a kind: free and connected with each other for a disc of
/// `radius_m`, or, in a world of rooms without a way, free and not connected.
std::vector<PlanTask> tasksIn(const WorldKind& kind, std::size_t count,
                              const GoalTolerance& tolerance, const Footprint& footprint,
                              const ObstacleOptions& options, std::uint64_t seed);

/// Whether start and goal are connected for a disc of that radius.
bool isConnected(const PlanTask& task, double radius_m);

/// How a behaviour misses its prediction before the next plan, drawn: some 4 mm and half a degree.
Pose2 drawMiss(Random& random);

/// Plans, measures, plans again from where the first behaviour ends and from beside that, and
/// checks.
class PlanTrials {
 public:
  /// Keeps references.
  PlanTrials(const Repertoire& repertoire, const Planner& planner, const EntryPaths& paths,
             const Footprint& footprint)
      : repertoire_(repertoire), planner_(planner), paths_(paths), footprint_(footprint) {}

  PlanTrial run(const PlanTask& task, Random& random) const;

 private:
  Replan planAgain(const PlanTask& task, const PlanResult& plan, const Pose2& miss) const;
  double clearance_m(const PlanTask& task, const PlanResult& plan) const;

  const Repertoire& repertoire_;
  const Planner& planner_;
  const EntryPaths& paths_;
  const Footprint& footprint_;
};

/// One line of the report for trials of one kind, in the columns of kPlanHeading.
std::string describe(const std::string& name, const std::vector<PlanTrial>& trials);
extern const char* const kPlanHeading;

}  // namespace hexapod
