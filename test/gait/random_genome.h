#pragma once

#include <cstdint>

#include "common/random.h"
#include "gait/genome.h"

namespace hexapod {

/// Every gene drawn at random; as many as the paper's hexapod has.
inline Genome randomGenome(Random& random, std::size_t genes = 24) {
  Genome genome(genes);
  for (auto& level : genome) level = static_cast<std::uint8_t>(random.below(kGeneLevels));
  return genome;
}

}  // namespace hexapod
