#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "common/options.h"
#include "evolution/evolution_options.h"
#include "gait/behavior_options.h"
#include "robot/robot_description.h"

namespace hexapod {

/// Everything a learning run can be told. config/learn.yaml holds the same names.
struct LearnOptions {
  std::string repertoire_file;
  bool overwrite = false;
  std::int64_t evaluations = 20000;
  std::int64_t seed = 1;
  std::int64_t threads = 0;
  std::string engine = "ode";
  double step_s = 0.015;
  std::int64_t validation_trials = 8;
  double checkpoint_period_s = 10.0;
  EvolutionOptions evolution;
  BehaviorOptions behavior;
};

/// The options under their names, bound to `options`, which must outlive them.
std::vector<Option> declareOptions(LearnOptions& options);

/// Names a run by what determines its result: robot, options, seed. Equal runs have equal names.
std::string runId(const RobotDescription& robot, const std::map<std::string, std::string>& options);

}  // namespace hexapod
