#pragma once

#include <cstddef>
#include <string>

namespace hexapod {

/// What a generation of BR-Evolution costs beside its simulations.
struct GenerationCost {
  std::size_t archive = 0;     ///< entries
  std::size_t candidates = 0;  ///< evaluations of a generation
  double cpu_s = 0.0;          ///< of a generation, an evaluator that simulates nothing included
  double peak_memory_mb = 0.0;
};

/// Generations of default options, with an archive of about so many entries spread over a disc of
/// 0.9 m; candidates end there, too.
GenerationCost measureGeneration(std::size_t archive, std::size_t gene_count);

/// A row of the table whose heading is kEvolutionHeading. The share is that of a generation whose
/// candidates are all simulated, in `evaluation_cpu_s` each.
std::string describe(const GenerationCost& cost, double evaluation_cpu_s);
extern const char* const kEvolutionHeading;

}  // namespace hexapod
