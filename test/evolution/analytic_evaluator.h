#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "common/random.h"
#include "evolution/evaluator.h"

namespace hexapod {

/// A smooth stand-in for the simulation: forward, sideways and turning speed are linear in the gene
/// values with random weights; a genome falls when one sum of its genes is large.
class AnalyticEvaluator : public Evaluator {
 public:
  explicit AnalyticEvaluator(std::uint64_t seed = 7, std::size_t gene_count = 24) {
    Random random(seed);
    weights_.resize(gene_count);
    for (auto& weight : weights_) {
      for (double& component : weight) component = random.uniform(-0.5, 0.5);
    }
  }

  std::vector<Outcome> evaluate(const std::vector<Genome>& genomes) override {
    calls += 1;
    candidates += static_cast<std::int64_t>(genomes.size());
    std::vector<Outcome> outcomes;
    outcomes.reserve(genomes.size());
    for (const Genome& genome : genomes) outcomes.push_back(outcomeOf(genome));
    return outcomes;
  }

  Outcome outcomeOf(const Genome& genome) const {
    std::array<double, 4> sums{};
    for (std::size_t gene = 0; gene < genome.size(); ++gene) {
      for (std::size_t k = 0; k < sums.size(); ++k) {
        sums[k] += weights_[gene][k] * (geneValue(genome[gene]) - 0.5);
      }
    }
    if (sums[3] > 0.9) return {Verdict::kFell, {}, 0.0};
    return walkedTo({0.5 * sums[0], 0.5 * sums[1], 2.0 * sums[2]});
  }

  std::int64_t calls = 0;
  std::int64_t candidates = 0;

 private:
  std::vector<std::array<double, 4>> weights_;
};

}  // namespace hexapod
