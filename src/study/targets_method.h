#pragma once

#include "study/method.h"
#include "study/target_evolution.h"

namespace hexapod {

/// The control experiments of Cully & Mouret 2013, section 4.2: a TargetEvolution for every target.
///
/// Both of the paper's variants are chosen from the same runs ("we also save"): "nearest" keeps
/// each target's nearest on the Pareto front, "orientation" the best aligned within a radius; a
/// target without any gives no entry. The paper runs one target after the other; here they take
/// turns, a generation each, so that the repertoire at a smaller budget is that of a shorter run.
/// The id of an entry is the number of its target, from 1.
class TargetsMethod : public Method {
 public:
  /// As TargetEvolution's constructor; each target has a generator of its own, seeded from
  /// `random`. Throws std::invalid_argument without targets.
  TargetsMethod(const EvolutionOptions& options, const GenomeSpace& space, Evaluator& evaluator,
                Random random, const std::vector<Target>& targets, double radius_m);

  /// One generation of the target whose turn it is.
  void step(std::int64_t most_candidates) override;
  std::int64_t evaluations() const override { return evaluations_; }
  std::map<std::string, std::vector<Entry>> repertoires() const override;

 private:
  double radius_m_;
  std::vector<TargetEvolution> evolutions_;
  std::size_t turn_ = 0;
  std::int64_t evaluations_ = 0;
};

}  // namespace hexapod
