#include "evolution/algorithms.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

#include "common/text.h"
#include "evolution/br_evolution.h"
#include "evolution/map_elites.h"

namespace hexapod {
namespace {

constexpr const char* kBrEvolution = "br_evolution";
constexpr const char* kMapElites = "map_elites";
constexpr const char* kCvtMapElites = "cvt_map_elites";

void requireKnown(const std::string& name) {
  const std::vector<std::string> names = algorithmNames();
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  throw std::invalid_argument("There is no algorithm '" + name + "'; there are " + listed(names) +
                              ".");
}

/// `start`: the generator of a new run, or the state to go on from.
template <typename Start>
std::unique_ptr<Generational> make(const AlgorithmChoice& choice, const Task& task,
                                   const Start& start) {
  requireKnown(choice.name);
  if (choice.name == kBrEvolution) {
    return std::make_unique<BrEvolution>(choice.evolution, task, start);
  }
  const MapElitesOptions& map = choice.map_elites;
  const PoseMetric metric = metricOf(choice.evolution);
  if (choice.name == kCvtMapElites && metric.heading_m_per_rad > 0.0) {
    throw std::invalid_argument(
        "The option heading_m_per_rad is above 0, and cvt_map_elites has cells of the plane only: "
        "choose map_elites or br_evolution, or set it to 0.");
  }
  const Cells cells = choice.name == kCvtMapElites
                          ? voronoiCells(static_cast<std::size_t>(map.cvt_cells), map.cvt_radius_m)
                          : gridCells(map.cell_m, metric);
  return std::make_unique<MapElites>(choice.evolution, task, cells, start);
}

}  // namespace

std::vector<std::string> algorithmNames() { return {kBrEvolution, kMapElites, kCvtMapElites}; }

std::unique_ptr<Generational> makeAlgorithm(const AlgorithmChoice& choice, const Task& task,
                                            const Random& random) {
  return make(choice, task, random);
}

std::unique_ptr<Generational> makeAlgorithm(const AlgorithmChoice& choice, const Task& task,
                                            const EvolutionState& state) {
  return make(choice, task, state);
}

}  // namespace hexapod
