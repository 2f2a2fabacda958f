#pragma once

#include <cstdint>
#include <vector>

#include "common/random.h"
#include "evolution/nsga2.h"
#include "gait/genome.h"
#include "gait/outcome.h"
#include "repertoire/entry.h"

namespace hexapod {

/// A candidate that was evaluated.
struct Individual {
  std::int64_t id = 0;          ///< unique within the run; its entry in the archive has the same
  std::int64_t evaluation = 0;  ///< its number among the candidates of the run, from 1
  Genome genotype;              ///< the genes as they are inherited and mutated
  Genome genome;                ///< canonical(genotype): what is simulated, compared and archived
  Outcome outcome;
  Standing standing;       ///< among the parents and children it was last selected from
  int looks = 0;           ///< number of the look that gave the outcome (see Evaluator)
  double disparity = 0.0;  ///< Transferability, where there is any

  /// What it competes with: lower is better.
  double price() const { return outcome.cost + disparity; }
};

/// The entry an individual that walked makes.
Entry entryOf(const Individual& individual);

/// The individual an entry goes on as in the population, its outcome that of look number `looks`;
/// its standing is yet to be found.
Individual individualOf(const Entry& entry, int looks);

/// What has happened in a run so far.
struct EvolutionCounters {
  std::int64_t generations = 0;
  std::int64_t evaluations = 0;  ///< candidates, those of the initial population included
  std::int64_t fell = 0;
  std::int64_t self_collided = 0;
  std::int64_t diverged = 0;
  std::int64_t added = 0;
  std::int64_t swapped = 0;
  std::int64_t looked_twice = 0;  ///< candidates the evaluator had to look at again
  std::int64_t failed_later = 0;  ///< of those that failed, the ones that did so in a further look
};

/// Everything a run needs to go on exactly as if it had never stopped.
struct EvolutionState {
  Random random{0};
  std::int64_t next_id = 1;
  EvolutionCounters counters;
  std::vector<Individual> population;  ///< empty before the first generation
  std::vector<Entry> archive;
};

}  // namespace hexapod
