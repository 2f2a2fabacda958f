#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "common/options.h"
#include "evaluation/robust_options.h"
#include "evolution/evolution_options.h"
#include "evolution/map_elites_options.h"
#include "gait/behavior_options.h"
#include "robot/robot_description.h"
#include "simulation/world.h"
#include "transferability/transfer_options.h"

namespace hexapod {

/// Everything a learning run can be told. config/learn.yaml holds the same names.
struct LearnOptions {
  std::string repertoire_file;
  bool overwrite = false;
  bool resume = false;
  bool check_again = false;
  std::int64_t evaluations = 0;  ///< 0: see withBudget()
  double time_budget_s = 0.0;
  std::int64_t seed = 1;
  std::int64_t threads = 0;
  std::string algorithm = "br_evolution";
  std::string from;  ///< in a run: what names the entries that it began with (warm_start.h)
  std::string body;
  std::string engine = "reduced";
  double step_s = 0.015;
  double length_scale = 0.0;  ///< of all lengths below; 0: the robot's own
  bool verify_with_ode = true;
  std::int64_t verification_sample = 60;
  bool resimulate = true;
  std::int64_t validation_trials = 8;
  double checkpoint_period_s = 5.0;
  std::int64_t cached_genomes = 300000;
  double worker_patience_s = 60.0;
  EvolutionOptions evolution;
  MapElitesOptions map_elites;
  BehaviorOptions behavior;
  RobustnessOptions robustness;
  TransferOptions transfer;
};

/// The options under their names, bound to `options`, which must outlive them.
std::vector<Option> declareOptions(LearnOptions& options);

/// The options with a budget of evaluations: 20,000 where none is given, or as many as the time
/// budget allows where there is that.
LearnOptions withBudget(LearnOptions options);

/// The same with all lengths multiplied by `length_scale`, or by the robot's own strideScale()
/// where that is 0, with what counts per metre divided by it, and with the body in one spelling.
/// Throws std::invalid_argument as bodyFromText() does.
LearnOptions suitedTo(const RobotDescription& robot, LearnOptions options);

/// The physics that candidates are simulated with first.
Physics nominalPhysics(const RobotDescription& robot, const LearnOptions& options);

/// The options that say what is learned, as texts by name, as the repertoire keeps them. Where it
/// is kept, how often it is saved and how many threads work makes no difference to it.
std::map<std::string, std::string> resultOptions(const LearnOptions& options);

/// True for those of resultOptions() that only say when learning ends.
bool isBudget(const std::string& option_name);

/// True for those that only say how the entries are checked then.
bool isCheck(const std::string& option_name);

/// Names a run by what determines its result: robot, options, seed. Equal runs have equal names.
std::string runId(const RobotDescription& robot, const std::map<std::string, std::string>& options);

}  // namespace hexapod
