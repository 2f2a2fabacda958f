#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/options.h"

namespace hexapod {

/// What the program bench can be told.
struct BenchOptions {
  bool help = false;
  std::int64_t agreement = 0;
  std::int64_t learning = 0;
  std::int64_t seed = 1;
  std::int64_t threads = 0;
  double seconds_per_case = 8.0;
};

/// The options under their names, bound to `options`, which must outlive them.
std::vector<Option> declareOptions(BenchOptions& options);

/// Reads `--name value` pairs and --help. Throws std::invalid_argument with a sentence for every
/// problem.
BenchOptions benchOptionsFrom(const std::vector<std::string>& arguments);

/// Usage and the table of all options.
std::string benchHelp();

}  // namespace hexapod
