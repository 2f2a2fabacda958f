#include "learning/learn_options.h"

#include <limits>

#include "repertoire/digest.h"

namespace hexapod {

std::vector<Option> declareOptions(LearnOptions& options) {
  constexpr std::int64_t kMany = 1000000000;
  std::vector<Option> all = {
      option("repertoire_file", options.repertoire_file, "SQLite file the repertoire is written to."),
      option("overwrite", options.overwrite, "Replace a repertoire that repertoire_file already holds."),
      option("evaluations", options.evaluations, "Candidates to evaluate.", 1, kMany),
      option("seed", options.seed, "Seed of everything random; same seed, same repertoire.", 0,
             std::numeric_limits<std::int32_t>::max()),
      option("threads", options.threads, "Threads that simulate; 0: all cores.", 0, 1024),
      option("engine", options.engine, "Simulation engine.", {"ode"}),
      option("step_s", options.step_s, "s",
             "Step of the simulation; the command period must be a multiple of it.", 1e-4, 0.05),
      option("validation_trials", options.validation_trials,
             "Executions of each entry after random predecessors when learning is done; 0: none.",
             0, 1000),
      option("checkpoint_period_s", options.checkpoint_period_s, "s",
             "The file is written at least this often while learning.", 0.0, 86400.0)};
  for (auto& more : {declareOptions(options.evolution), declareOptions(options.behavior)}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

std::string runId(const RobotDescription& robot,
                  const std::map<std::string, std::string>& options) {
  Digest digest;
  digest.add(robot.digest);
  for (const auto& [name, text] : options) {
    digest.add(name);
    digest.add(text);
  }
  return robot.name + "-seed" + options.at("seed") + "-" + digest.text().substr(0, 8);
}

}  // namespace hexapod
