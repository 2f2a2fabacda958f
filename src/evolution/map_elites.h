#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "evolution/cells.h"
#include "evolution/evolution_options.h"
#include "evolution/generational.h"

namespace hexapod {

/// MAP-Elites (Mouret & Clune 2015) on ends: the plane, or the space of poses, is cut into cells,
/// and each keeps the controller of the least cost that ended in it, of equally good ones the
/// first. Candidates are mutated copies of elites drawn uniformly; they are drawn at random until
/// something has walked.
///
/// Of the options it takes candidates (0: population_size of them), mutation_rate and
/// offer_twins: with that the mirror images of a candidate compete for their cells, too. In a task
/// with further looks those candidates are looked at again that would take a cell by the outcome
/// they have, themselves or a twin; only final outcomes compete, each for the cell it ends in. Of
/// the counters, `added` are cells that were empty, `swapped` those that got a better elite.
class MapElites : public Generational {
 public:
  /// A new run. Throws std::invalid_argument naming what is out of range.
  MapElites(const EvolutionOptions& options, const Task& task, const Cells& cells,
            const Random& random);

  /// Goes on from state() of another one with the same options, task and cells, its entries in
  /// their order. Throws std::invalid_argument as above, or when the state does not fit.
  MapElites(const EvolutionOptions& options, const Task& task, const Cells& cells,
            const EvolutionState& state);

  /// The elites, in the order in which their cells were found.
  const std::vector<Entry>& entries() const override { return elites_; }

 private:
  std::vector<Genome> breed(std::size_t count, Random& random) const override;
  std::vector<std::size_t> promising(const std::vector<Individual>& pool, int looks) const override;
  void finish(Pool pool) override;
  void judgeEntries() override;

  /// The place among elites_ that the individual would take; nothing when it would take none.
  std::optional<std::size_t> placeFor(const Individual& individual) const;
  void offer(const Individual& individual);

  EvolutionOptions options_;
  Cells cells_;
  std::vector<Entry> elites_;
  std::map<Cell, std::size_t> places_;  // of the cells' elites
  std::set<Genome> genomes_;            // of the elites
};

}  // namespace hexapod
