#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "evolution/genome_space.h"
#include "gait/symmetry.h"

namespace hexapod {

/// Calls work(i) once for every i < count, in any order, perhaps by several threads at once;
/// returns when all are done.
using Spread = std::function<void(std::size_t count, const std::function<void(std::size_t)>& work)>;

/// What an algorithm is told of the task it works on; whoever answers its questions knows the rest.
struct Task {
  GenomeSpace space;
  int looks = 1;                     ///< number of the look that is final (see Evaluator), >= 1
  std::vector<Symmetry> symmetries;  ///< give twins, where an algorithm offers them
  /// Does what an algorithm has to do for each of many: no result depends on it.
  Spread spread = oneByOne;

  /// Gaits of so many genes that one look is enough for.
  Task(std::size_t gait_genes) : space(gait_genes) {}
  Task(GenomeSpace space, int looks = 1, std::vector<Symmetry> symmetries = {})
      : space(std::move(space)), looks(looks), symmetries(std::move(symmetries)) {}

  static void oneByOne(std::size_t count, const std::function<void(std::size_t)>& work) {
    for (std::size_t i = 0; i < count; ++i) work(i);
  }
};

}  // namespace hexapod
