#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/options.h"

namespace hexapod {

/// What the program bench_plan can be told.
struct BenchPlanOptions {
  bool help = false;
  std::string repertoire;
  std::string csv;
  std::int64_t seed = 1;
  std::int64_t goals = 1000;
  std::int64_t world_goals = 100;
  std::int64_t routes = 0;
  std::int64_t walks = 0;
  std::string write;
};

/// The options under their names, bound to `options`, which must outlive them.
std::vector<Option> declareOptions(BenchPlanOptions& options);

/// Reads `--name value` pairs and --help. Throws std::invalid_argument with a sentence for every
/// problem.
BenchPlanOptions benchPlanOptionsFrom(const std::vector<std::string>& arguments);

/// Usage and the table of all options.
std::string benchPlanHelp();

}  // namespace hexapod
