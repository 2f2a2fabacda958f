#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace hexapod {

/// One run of a study: an algorithm, a seed and a budget of candidates.
struct RunPlan {
  std::string algorithm;
  std::int64_t seed = 1;
  std::int64_t evaluations = 1000000;

  /// "br_evolution_3_1000000".
  std::string name() const {
    return algorithm + "_" + std::to_string(seed) + "_" + std::to_string(evaluations);
  }
};

}  // namespace hexapod
