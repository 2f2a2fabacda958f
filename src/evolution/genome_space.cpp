#include "evolution/genome_space.h"

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace hexapod {

GenomeSpace gaits(std::size_t genes, std::size_t levels) {
  return {genes, levels,
          [levels](const Genome& genome) { return hexapod::canonical(genome, levels); }};
}

GenomeSpace gaitsOf(const RobotDescription& robot, const BehaviorOptions& options) {
  return gaits(robot.geneCount(), static_cast<std::size_t>(options.gene_levels));
}

GenomeSpace::GenomeSpace(std::size_t gait_genes) : GenomeSpace(gaits(gait_genes, kGeneLevels)) {}

GenomeSpace::GenomeSpace(std::size_t gene_count, std::size_t levels,
                         std::function<Genome(const Genome&)> canonical)
    : gene_count(gene_count), levels(levels), canonical(std::move(canonical)) {}

Genome GenomeSpace::drawn(Random& random) const {
  Genome genotype(gene_count);
  for (auto& level : genotype) level = static_cast<std::uint8_t>(random.below(levels));
  return genotype;
}

Genome GenomeSpace::mutated(const Genome& genotype, double rate, Random& random) const {
  Genome child = genotype;
  for (auto& level : child) {
    if (!random.chance(rate)) continue;
    level = static_cast<std::uint8_t>(random.below(levels));
  }
  return child;
}

void requireValid(const GenomeSpace& space) {
  if (space.gene_count == 0) {
    throw std::invalid_argument("An evolution needs genomes of 1 gene or more.");
  }
  constexpr std::size_t kMostLevels = std::numeric_limits<Genome::value_type>::max() + 1;
  if (space.levels >= 1 && space.levels <= kMostLevels) return;
  throw std::invalid_argument("A gene has " + std::to_string(space.levels) +
                              " levels: expected 1 .. " + std::to_string(kMostLevels) + ".");
}

}  // namespace hexapod
