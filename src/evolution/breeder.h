#pragma once

#include <cstddef>
#include <vector>

#include "common/random.h"
#include "evolution/evolution_options.h"
#include "evolution/genome_space.h"
#include "evolution/individual.h"
#include "evolution/nsga2.h"
#include "repertoire/archive.h"

namespace hexapod {

/// Draws the genotypes of one generation's candidates: random ones as long as there is no
/// population, then children of one parent each, which is drawn by a tournament in the population
/// or, for the share archive_parents, by one among neighbours in the archive. Space, population and
/// archive must outlive it, unchanged; the order of the archive's entries plays no part.
class Breeder {
 public:
  Breeder(const EvolutionOptions& options, const GenomeSpace& space,
          const std::vector<Individual>& population, const Archive& archive);

  Genome next(Random& random) const;

 private:
  const Genome& parent(Random& random) const;
  const Entry& bestAround(const Entry& entry) const;

  double mutation_rate_;
  double archive_parents_;
  std::size_t archive_tournament_;
  const GenomeSpace& space_;
  const std::vector<Individual>& population_;
  const Archive& archive_;
  std::vector<Standing> standings_;    // of the population
  std::vector<const Entry*> entries_;  // by id; none unless parents come from the archive
};

}  // namespace hexapod
