#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evolution/evaluator.h"
#include "evolution/evolution_options.h"
#include "evolution/genome_space.h"
#include "evolution/individual.h"

namespace hexapod {

/// One end position that a controller is wanted for [m].
struct Target {
  double x_m = 0.0;
  double y_m = 0.0;
};

/// NSGA-II (Deb et al. 2002) towards one target: the control experiment of Cully & Mouret 2013,
/// section 4.2. Minimises the distance of the end position from the target and the orientation
/// error; parents by binary tournament, mutation without crossover (appendix A), crowding distance,
/// parents and children selected together. What fell, collided or diverged is worst in both.
///
/// Of the options it takes population_size and mutation_rate.
class TargetEvolution {
 public:
  /// Throws std::invalid_argument naming an option or a number of the space that is out of range.
  /// The evaluator must outlive the evolution.
  TargetEvolution(const EvolutionOptions& options, const GenomeSpace& space, Evaluator& evaluator,
                  const Random& random, const Target& target);

  /// One generation, or the first `most_candidates` (>= 1) candidates of it; the first one is drawn
  /// at random.
  void step(std::int64_t most_candidates);

  const Target& target() const { return target_; }
  const std::vector<Individual>& population() const { return population_; }
  std::int64_t evaluations() const { return evaluations_; }

  /// Of those on the Pareto front the one that ends nearest to the target, of equally near ones the
  /// better aligned. Nothing before any has walked.
  std::optional<Individual> nearest() const;

  /// The best aligned one that ends within `radius_m` of the target, of equally aligned ones the
  /// nearest (it is on the Pareto front, too). Nothing when none ends there.
  std::optional<Individual> bestAligned(double radius_m) const;

 private:
  double distance(const Individual& individual) const;
  Objectives objectives(const Individual& individual) const;

  EvolutionOptions options_;
  GenomeSpace space_;
  Evaluator* evaluator_;
  Random random_;
  Target target_;
  std::int64_t evaluations_ = 0;
  std::vector<Individual> population_;
};

}  // namespace hexapod
