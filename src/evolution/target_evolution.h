#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "evolution/evolution_options.h"
#include "evolution/generational.h"
#include "evolution/individual.h"
#include "evolution/nsga2.h"
#include "evolution/target.h"

namespace hexapod {

/// NSGA-II (Deb et al. 2002) towards one target: the control experiment of Cully & Mouret 2013,
/// section 4.2. Minimises the distance of the end position from the target and the orientation
/// error; parents by binary tournament, mutation without crossover (appendix A), crowding distance,
/// parents and children selected together. What fell, collided or diverged is worst in both.
///
/// Of the options it takes population_size and mutation_rate; it takes one look at each candidate.
class TargetEvolution : public Generational {
 public:
  /// Throws std::invalid_argument naming an option or a number of the space that is out of range.
  TargetEvolution(const EvolutionOptions& options, const GenomeSpace& space, const Random& random,
                  const Target& target);

  /// The Pareto front: those of the population that walked and that nobody dominates.
  const std::vector<Entry>& entries() const override { return front_; }

  /// Of those on the Pareto front the one that ends nearest to the target, of equally near ones the
  /// better aligned. Nothing before any has walked.
  std::optional<Individual> nearest() const;

  /// The best aligned one that ends within `radius_m` of the target, of equally aligned ones the
  /// nearest (it is on the Pareto front, too). Nothing when none ends there.
  std::optional<Individual> bestAligned(double radius_m) const;

 private:
  std::vector<Genome> breed(std::size_t count, Random& random) const override;
  std::vector<std::size_t> promising(const std::vector<Individual>& pool, int looks) const override;
  void finish(Pool pool) override;
  void judgeEntries() override;

  double distance(const Individual& individual) const;
  Objectives objectives(const Individual& individual) const;

  EvolutionOptions options_;
  Target target_;
  std::vector<Entry> front_;
};

}  // namespace hexapod
