#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

#include "gait/genome.h"

namespace hexapod {

/// For unordered containers of genomes.
struct GenomeHash {
  std::size_t operator()(const Genome& genome) const {
    const auto* bytes = reinterpret_cast<const char*>(genome.data());
    return std::hash<std::string_view>()({bytes, genome.size()});
  }
};

}  // namespace hexapod
