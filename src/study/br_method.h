#pragma once

#include "evolution/br_evolution.h"
#include "study/method.h"

namespace hexapod {

/// BR-Evolution as a method of a study: its repertoire is its archive.
class BrMethod : public Method {
 public:
  /// As BrEvolution's constructor.
  BrMethod(const EvolutionOptions& options, const GenomeSpace& space, Evaluator& evaluator,
           const Random& random, std::vector<Symmetry> symmetries = {})
      : evolution_(options, space, evaluator, random, std::move(symmetries)) {}

  void step(std::int64_t most_candidates) override { evolution_.step(most_candidates); }
  std::int64_t evaluations() const override { return evolution_.counters().evaluations; }
  std::map<std::string, std::vector<Entry>> repertoires() const override {
    return {{"br_evolution", evolution_.archive().entries()}};
  }

 private:
  BrEvolution evolution_;
};

}  // namespace hexapod
