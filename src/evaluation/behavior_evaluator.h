#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "evaluation/robust_worlds.h"
#include "evolution/evaluator.h"
#include "simulation/world_pool.h"

namespace hexapod {

/// How many behaviours were simulated and how they ended.
struct SimulationCounts {
  std::int64_t simulations = 0;
  std::int64_t fell = 0;
  std::int64_t self_collided = 0;
  std::int64_t diverged = 0;

  std::int64_t failures() const { return fell + self_collided + diverged; }
};

/// Evaluates genomes by playing each one's behaviour once, from the settled stand.
///
/// Equal gaits have equal outcomes. An outcome depends on its genome alone, whatever the number of
/// threads.
class BehaviorEvaluator : public Evaluator {
 public:
  /// Throws std::invalid_argument when the options do not fit the robot. `cancelled`, if given,
  /// must outlive the evaluator.
  BehaviorEvaluator(const std::shared_ptr<WorldPool>& worlds, const BehaviorOptions& options,
                    const std::atomic<bool>* cancelled = nullptr);

  /// Throws std::runtime_error naming the genome when one cannot be simulated at all, and
  /// EvaluationCancelled once `cancelled` turns true, within one simulated behaviour.
  std::vector<Outcome> evaluate(const std::vector<Genome>& genomes) override;

  /// Since construction.
  const SimulationCounts& counts() const { return counts_; }

  /// How full the registers were so far.
  LaneUse use() const { return worlds_.use(); }

 private:
  RobustWorlds worlds_;
  const std::atomic<bool>* cancelled_;
  SimulationCounts counts_;
};

}  // namespace hexapod
