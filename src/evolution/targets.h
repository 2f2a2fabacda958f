#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evolution/algorithm.h"
#include "evolution/evolution_options.h"
#include "evolution/target_evolution.h"

namespace hexapod {

/// The control experiments of Cully & Mouret 2013, section 4.2: a TargetEvolution for every target.
///
/// Both of the paper's variants are chosen from the same runs ("we also save"): nearest() has each
/// target's nearest on the Pareto front, bestAligned() the best aligned within a radius; a target
/// without any gives no entry. The paper runs one target after the other; here they take turns, a
/// generation each, so that what there is at a smaller budget is that of a shorter run. The id of
/// an entry is the number of its target, from 1.
class Targets : public Algorithm {
 public:
  /// As TargetEvolution's constructor; each target has a generator of its own, seeded from
  /// `random`. Throws std::invalid_argument without targets.
  Targets(const EvolutionOptions& options, const GenomeSpace& space, Random random,
          const std::vector<Target>& targets, double radius_m);

  /// A generation is one of the target whose turn it is.
  const Questions& ask(
      std::int64_t most_candidates = std::numeric_limits<std::int64_t>::max()) override {
    return evolutions_[turn_].ask(most_candidates);
  }
  void tell(const std::vector<Outcome>& outcomes) override;

  /// nearest().
  const std::vector<Entry>& entries() const override { return nearest_; }
  const EvolutionCounters& counters() const override { return counters_; }

  const std::vector<Entry>& nearest() const { return nearest_; }
  const std::vector<Entry>& bestAligned() const { return best_aligned_; }

 private:
  void choose();

  double radius_m_;
  std::vector<TargetEvolution> evolutions_;
  std::size_t turn_ = 0;
  EvolutionCounters counters_;  // generations, evaluations and failures of all
  std::vector<Entry> nearest_;
  std::vector<Entry> best_aligned_;
};

}  // namespace hexapod
