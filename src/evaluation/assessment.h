#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "evaluation/robust_worlds.h"
#include "repertoire/entry.h"
#include "repertoire/metrics.h"
#include "repertoire/repertoire.h"
#include "simulation/world_pool.h"

namespace hexapod {

/// A world to try a repertoire in.
struct Trial {
  std::string name;
  Physics physics;
};

/// The nominal physics first, then those that repertoires are judged by and learning does not
/// use: a 5 ms step, friction 0.7 and 1.1, masses and servo gains 10 and 20 % off, torque 20 %
/// less.
std::vector<Trial> heldOutTrials(const RobotDescription& robot, const Physics& nominal);

/// What is left of a repertoire in a trial.
struct TrialResult {
  std::string name;
  RepertoireMetrics metrics;  ///< of the entries that walked, by where they ended here
  std::int64_t failed = 0;
  double median_shift_m = 0.0;  ///< from the expected poses, of the entries that walked
  double p90_shift_m = 0.0;
};

/// Plays every entry once from the stand in each trial. The pool gives engine and threads. Throws
/// EvaluationCancelled as RobustWorlds does.
std::vector<TrialResult> resimulate(const std::shared_ptr<WorldPool>& pool,
                                    const BehaviorOptions& behavior,
                                    const std::vector<Entry>& entries,
                                    const std::vector<Trial>& trials, const PlayHooks& hooks = {});

/// Medians over the trials but the first, which is the nominal one.
HeldOut heldOutMedians(const std::vector<TrialResult>& results);

/// The results as texts by name, in the form in which a repertoire keeps them among its facts:
/// "resimulated.5 ms step.sparseness_m" and so on.
std::map<std::string, std::string> factsOf(const std::vector<TrialResult>& results);

}  // namespace hexapod
