#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "evolution/evaluator.h"
#include "evolution/evolution_options.h"
#include "evolution/genome_space.h"
#include "repertoire/entry.h"
#include "study/method.h"

namespace hexapod {

/// MAP-Elites (Mouret & Clune 2015) on end positions: the plane is cut into square cells, and each
/// keeps the best aligned controller that ended in it. Candidates are mutated copies of entries
/// drawn uniformly; the first generation is drawn at random, and so are later ones until something
/// has walked.
///
/// Of the options it takes population_size, the candidates of a generation, and mutation_rate. An
/// elite yields to a better one only.
class MapElites : public Method {
 public:
  /// Cells of `cell_m` x `cell_m` [m], > 0, one of them centred on the origin. Throws
  /// std::invalid_argument naming what is out of range. The evaluator must outlive this.
  MapElites(const EvolutionOptions& options, const GenomeSpace& space, Evaluator& evaluator,
            const Random& random, double cell_m);

  void step(std::int64_t most_candidates) override;
  std::int64_t evaluations() const override { return evaluations_; }
  std::map<std::string, std::vector<Entry>> repertoires() const override;

 private:
  using Cell = std::pair<std::int64_t, std::int64_t>;
  Cell cellOf(const Entry& entry) const;
  void offer(const Entry& entry);

  EvolutionOptions options_;
  GenomeSpace space_;
  Evaluator* evaluator_;
  Random random_;
  double cell_m_;
  std::int64_t evaluations_ = 0;
  std::vector<Entry> elites_;           // in the order in which their cells were found
  std::map<Cell, std::size_t> places_;  // of the cells' elites
};

}  // namespace hexapod
