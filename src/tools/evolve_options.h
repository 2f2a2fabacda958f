#pragma once

#include <string>
#include <vector>

#include "learning/learn_options.h"

namespace hexapod {

/// What the program evolve can be told.
struct EvolveOptions {
  LearnOptions learn;
  std::string preset = "learn";
  std::string config;
  std::string urdf;
  std::string robot_config;
  std::string csv;
  double progress_period_s = 5.0;
  bool help = false;
};

/// The options under their names, bound to `options`, which must outlive them.
std::vector<Option> declareOptions(EvolveOptions& options);

/// Reads the command line: `--name value` or `--name=value` for every declared option, `--name`
/// alone for those that are true or false; --file and --seconds are short for repertoire_file and
/// time_budget_s. The preset's file comes first, then that of --config, then the command line; urdf
/// and robot_config are set to the shipped robot's when left empty.
///
/// Throws std::invalid_argument with a sentence for every problem (see applyOptions), or
/// std::runtime_error for a file that cannot be read. After --help neither file nor robot is looked
/// for.
EvolveOptions evolveOptionsFrom(const std::vector<std::string>& arguments);

/// Usage, and all options with the values that they have in `options`.
std::string evolveHelp(EvolveOptions options);

}  // namespace hexapod
