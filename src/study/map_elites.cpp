#include "study/map_elites.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hexapod {

MapElites::MapElites(const EvolutionOptions& options, const GenomeSpace& space,
                     Evaluator& evaluator, const Random& random, double cell_m)
    : options_(options), space_(space), evaluator_(&evaluator), random_(random), cell_m_(cell_m) {
  requireValid(options);
  requireValid(space);
  if (cell_m > 0.0 && std::isfinite(cell_m)) return;
  throw std::invalid_argument("MAP-Elites has cells of " + std::to_string(cell_m) +
                              " m: expected more than 0.");
}

void MapElites::step(std::int64_t most_candidates) {
  const auto size = static_cast<std::size_t>(std::min(options_.population_size, most_candidates));
  std::vector<Genome> genomes;
  for (std::size_t i = 0; i < size; ++i) {
    const Genome genotype = elites_.empty()
                                ? space_.drawn(random_)
                                : space_.mutated(elites_[random_.below(elites_.size())].genome,
                                                 options_.mutation_rate, random_);
    genomes.push_back(space_.canonical(genotype));
  }
  const std::vector<Outcome> outcomes = evaluator_->evaluate(genomes);
  for (std::size_t i = 0; i < size; ++i) {
    ++evaluations_;
    const Outcome& outcome = outcomes.at(i);
    if (!outcome.walked()) continue;
    Entry entry;
    entry.id = entry.evaluation = evaluations_;
    entry.genome = genomes[i];
    entry.end_pose = outcome.end_pose;
    entry.cost = outcome.cost;
    offer(entry);
  }
}

std::map<std::string, std::vector<Entry>> MapElites::repertoires() const {
  return {{"map_elites", elites_}};
}

MapElites::Cell MapElites::cellOf(const Entry& entry) const {
  return {std::llround(entry.end_pose.x_m / cell_m_), std::llround(entry.end_pose.y_m / cell_m_)};
}

void MapElites::offer(const Entry& entry) {
  const auto [place, is_new] = places_.emplace(cellOf(entry), elites_.size());
  if (is_new) {
    elites_.push_back(entry);
  } else if (entry.cost < elites_[place->second].cost) {
    elites_[place->second] = entry;
  }
}

}  // namespace hexapod
