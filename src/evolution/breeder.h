#pragma once

#include <cstddef>
#include <vector>

#include "common/random.h"
#include "evolution/evolution_options.h"
#include "evolution/individual.h"
#include "evolution/nsga2.h"
#include "gait/genome.h"
#include "repertoire/archive.h"

namespace hexapod {

/// Draws the genotypes of one generation's candidates: random ones as long as there is no
/// population, then children of one parent each, which is drawn by a tournament in the population
/// or, for the share archive_parents, uniformly from the archive. Population and archive must
/// outlive it, unchanged; the order of the archive's entries plays no part.
class Breeder {
 public:
  Breeder(const EvolutionOptions& options, std::size_t gene_count,
          const std::vector<Individual>& population, const Archive& archive);

  Genome next(Random& random) const;

 private:
  const Genome& parent(Random& random) const;
  Genome mutated(const Genome& genotype, Random& random) const;

  double mutation_rate_;
  double archive_parents_;
  std::size_t gene_count_;
  const std::vector<Individual>& population_;
  std::vector<Standing> standings_;    // of the population
  std::vector<const Entry*> entries_;  // by id; none unless parents come from the archive
};

}  // namespace hexapod
