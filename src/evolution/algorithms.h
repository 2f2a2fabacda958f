#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/random.h"
#include "evolution/evolution_options.h"
#include "evolution/generational.h"
#include "evolution/map_elites_options.h"
#include "evolution/task.h"

namespace hexapod {

/// An algorithm by name, with the options of all.
struct AlgorithmChoice {
  std::string name;
  EvolutionOptions evolution;
  MapElitesOptions map_elites;
};

/// "br_evolution" (BrEvolution), "map_elites" and "cvt_map_elites" (MapElites on gridCells() and on
/// voronoiCells()).
std::vector<std::string> algorithmNames();

/// A new run. Throws std::invalid_argument for a name that is not among algorithmNames(), naming
/// those, and for options that are out of range.
std::unique_ptr<Generational> makeAlgorithm(const AlgorithmChoice& choice, const Task& task,
                                            const Random& random);

/// Goes on from state() of one with the same choice and task. Throws std::invalid_argument as
/// above, or when the state does not fit.
std::unique_ptr<Generational> makeAlgorithm(const AlgorithmChoice& choice, const Task& task,
                                            const EvolutionState& state);

}  // namespace hexapod
