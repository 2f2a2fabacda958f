#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/options.h"
#include "evolution/evolution_options.h"
#include "evolution/map_elites_options.h"
#include "gait/behavior_options.h"

namespace hexapod {

/// Everything that determines the result of one run of a study, besides robot, algorithm, seed and
/// budget. The defaults of its own are the paper's (section 4.2).
struct StudyOptions {
  std::int64_t targets = 100;     ///< of the control experiments
  std::int64_t targets_seed = 1;  ///< of the K-means that spreads them
  double target_radius_m = 0.10;  ///< "orientation" looks no further from a target [m]
  std::string engine = "reduced";
  double step_s = 0.015;
  EvolutionOptions evolution;
  MapElitesOptions map_elites;
  BehaviorOptions behavior;
};

/// The options under their names, bound to `options`, which must outlive them.
std::vector<Option> declareOptions(StudyOptions& options);

}  // namespace hexapod
