#pragma once

#include <cstddef>
#include <functional>

#include "common/random.h"
#include "gait/behavior_options.h"
#include "gait/genome.h"
#include "robot/robot_description.h"

namespace hexapod {

/// The genotypes of a task: strings of a fixed number of genes, each one of the levels
/// 0 .. levels - 1. What a level means is the evaluator's business: a setting, a real number of
/// some bits, a connection.
struct GenomeSpace {
  std::size_t gene_count = 0;        ///< >= 1
  std::size_t levels = kGeneLevels;  ///< 1 .. 256
  /// The genotype that stands for all that are the same controller (see Individual::genome).
  std::function<Genome(const Genome&)> canonical;

  /// Gaits of so many of the paper's genes. Implicit: they are what this package evolves.
  GenomeSpace(std::size_t gait_genes);

  /// Genotypes of another task, all of them different controllers unless `canonical` says more.
  GenomeSpace(
      std::size_t gene_count, std::size_t levels,
      std::function<Genome(const Genome&)> canonical = [](const Genome& same) { return same; });

  /// Each level equally likely.
  Genome drawn(Random& random) const;

  /// A copy in which each gene is drawn anew with probability `rate`, from all its levels.
  Genome mutated(const Genome& genotype, double rate, Random& random) const;
};

/// Gaits of so many genes, of so many levels.
GenomeSpace gaits(std::size_t genes, std::size_t levels);

/// The gaits that a robot plays with these options.
GenomeSpace gaitsOf(const RobotDescription& robot, const BehaviorOptions& options);

/// Throws std::invalid_argument naming the number that is out of its range.
void requireValid(const GenomeSpace& space);

}  // namespace hexapod
