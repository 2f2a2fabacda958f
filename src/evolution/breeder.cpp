#include "evolution/breeder.h"

#include <algorithm>

namespace hexapod {

Breeder::Breeder(const EvolutionOptions& options, const GenomeSpace& space,
                 const std::vector<Individual>& population, const Archive& archive)
    : mutation_rate_(options.mutation_rate),
      archive_parents_(options.archive_parents),
      archive_tournament_(static_cast<std::size_t>(options.archive_tournament)),
      space_(space),
      population_(population),
      archive_(archive) {
  standings_.reserve(population.size());
  for (const Individual& individual : population) standings_.push_back(individual.standing);
  if (archive_parents_ <= 0.0) return;
  for (const Entry& entry : archive.entries()) entries_.push_back(&entry);
  std::sort(entries_.begin(), entries_.end(),
            [](const Entry* a, const Entry* b) { return a->id < b->id; });
}

Genome Breeder::next(Random& random) const {
  if (population_.empty()) return space_.drawn(random);
  return space_.mutated(parent(random), mutation_rate_, random);
}

const Genome& Breeder::parent(Random& random) const {
  if (!entries_.empty() && random.chance(archive_parents_)) {
    return bestAround(*entries_[random.below(entries_.size())]).genome;
  }
  return population_[tournament(standings_, random)].genotype;
}

const Entry& Breeder::bestAround(const Entry& entry) const {
  if (archive_tournament_ <= 1) return entry;
  const Entry* best = &entry;
  for (const Neighbour& near : archive_.nearest(entry.end_pose, archive_tournament_)) {
    const Entry& rival = archive_.entries()[near.slot];
    if (rival.price() < best->price()) best = &rival;
  }
  return *best;
}

}  // namespace hexapod
