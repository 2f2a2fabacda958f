#include "evolution/map_elites.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace hexapod {

MapElites::MapElites(const EvolutionOptions& options, const Task& task, const Cells& cells,
                     const Random& random)
    : Generational(options.candidatesPerGeneration(), task, options.offer_twins, random),
      options_(options),
      cells_(cells) {
  requireValid(options);
}

MapElites::MapElites(const EvolutionOptions& options, const Task& task, const Cells& cells,
                     const EvolutionState& state)
    : MapElites(options, task, cells, state.random) {
  goOn(state);
  for (const Entry& entry : state.archive) {
    const bool is_new = places_.emplace(cells_(entry.end_pose), elites_.size()).second;
    if (!is_new) {
      throw std::invalid_argument("Entry " + std::to_string(entry.id) +
                                  " shares its cell with another: these are no elites of "
                                  "MAP-Elites with such cells.");
    }
    elites_.push_back(entry);
    genomes_.insert(entry.genome);
  }
}

std::vector<Genome> MapElites::breed(std::size_t count, Random& random) const {
  std::vector<Genome> genotypes;
  for (std::size_t i = 0; i < count; ++i) {
    genotypes.push_back(elites_.empty()
                            ? space().drawn(random)
                            : space().mutated(elites_[random.below(elites_.size())].genome,
                                              options_.mutation_rate, random));
  }
  return genotypes;
}

std::vector<std::size_t> MapElites::promising(const std::vector<Individual>& pool,
                                              int looks) const {
  std::vector<std::size_t> promising;
  for (std::size_t i = 0; i < pool.size(); ++i) {
    if (pool[i].looks != looks || !pool[i].outcome.walked()) continue;
    std::vector<Individual> images = twins(pool[i]);
    images.push_back(pool[i]);
    const bool takes_one = std::any_of(images.begin(), images.end(), [&](const Individual& image) {
      return placeFor(image).has_value();
    });
    if (takes_one) promising.push_back(i);
  }
  return promising;
}

void MapElites::finish(Pool pool) {
  for (const Individual& individual : pool.individuals) {
    if (!individual.outcome.walked() || individual.looks < this->looks()) continue;
    offer(individual);
    for (const Individual& twin : twins(individual)) offer(twin);
  }
}

void MapElites::judgeEntries() {
  for (Entry& elite : elites_) elite.disparity = disparityOf(elite);
}

std::optional<std::size_t> MapElites::placeFor(const Individual& individual) const {
  // A gait that is its own mirror image ends in one place, not in two.
  if (genomes_.count(individual.genome) > 0) return std::nullopt;
  const auto found = places_.find(cells_(individual.outcome.end_pose));
  if (found == places_.end()) return elites_.size();
  const bool is_better = individual.price() < elites_[found->second].price();
  return is_better ? std::optional<std::size_t>(found->second) : std::nullopt;
}

void MapElites::offer(const Individual& individual) {
  const std::optional<std::size_t> place = placeFor(individual);
  if (!place) return;
  if (*place == elites_.size()) {
    places_[cells_(individual.outcome.end_pose)] = *place;
    elites_.emplace_back();
    ++counters_.added;
  } else {
    genomes_.erase(elites_[*place].genome);
    ++counters_.swapped;
  }
  elites_[*place] = entryOf(individual);
  genomes_.insert(individual.genome);
}

}  // namespace hexapod
