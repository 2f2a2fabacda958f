#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study/run_plan.h"
#include "study/study_options.h"

namespace hexapod {

/// What the program study can be told; the defaults are the paper's study.
struct StudyCommand {
  std::string folder = "study";
  std::string algorithms = "br_evolution,targets,map_elites";  ///< names with commas between
  std::int64_t runs = 40;
  std::int64_t first_seed = 1;
  std::int64_t evaluations = 1000000;
  bool quick = false;
  std::int64_t jobs = 0;
  std::string preset = "learn_paper";
  std::string config;
  std::string urdf;
  std::string robot_config;
  StudyOptions study;
  bool help = false;
};

/// The options under their names, bound to `command`, which must outlive them.
std::vector<Option> declareOptions(StudyCommand& command);

/// Reads the command line (valuesFromCommandLine). Of the preset's file and that of `config` the
/// options of the study are taken, the others are the learner's alone. Throws std::invalid_argument
/// with a sentence for every problem, or std::runtime_error for a file that cannot be read. After
/// --help nothing is read.
StudyCommand studyCommandFrom(const std::vector<std::string>& arguments);

/// The runs asked for, all algorithms of a seed before the next seed.
std::vector<RunPlan> plansOf(const StudyCommand& command);

/// Usage and the table of all options.
std::string studyHelp();

}  // namespace hexapod
