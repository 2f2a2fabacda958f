#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "evolution/genome_space.h"
#include "gait/symmetry.h"

namespace hexapod {

/// What an algorithm is told of the task it works on; whoever answers its questions knows the rest.
struct Task {
  GenomeSpace space;
  int looks = 1;                     ///< number of the look that is final (see Evaluator), >= 1
  std::vector<Symmetry> symmetries;  ///< give twins, where an algorithm offers them

  /// Gaits of so many genes that one look is enough for.
  Task(std::size_t gait_genes) : space(gait_genes) {}
  Task(GenomeSpace space, int looks = 1, std::vector<Symmetry> symmetries = {})
      : space(std::move(space)), looks(looks), symmetries(std::move(symmetries)) {}
};

}  // namespace hexapod
