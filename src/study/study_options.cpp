#include "study/study_options.h"

#include <limits>

#include "simulation/world.h"

namespace hexapod {

std::vector<Option> declareOptions(StudyOptions& options) {
  std::vector<Option> all = {
      option("targets", options.targets, "Targets of the control experiments.", 1, 5000),
      option("targets_seed", options.targets_seed, "Seed of the K-means that spreads them.", 0,
             std::numeric_limits<std::int32_t>::max()),
      option("target_radius_m", options.target_radius_m, "m",
             "The control orientation keeps the best aligned controller that ends this near to a "
             "target.",
             0.001, 10.0),
      option("engine", options.engine,
             "Simulation engine: ODE, or its equations in reduced coordinates.", engineNames()),
      option("step_s", options.step_s, "s",
             "Step of the simulation; the command period must be a multiple of it.", 1e-4, 0.05)};
  for (auto& more : {declareOptions(options.evolution), declareOptions(options.map_elites),
                     declareOptions(options.behavior)}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

}  // namespace hexapod
