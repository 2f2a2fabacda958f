#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <vector>

#include "calibration/calibration_report.h"
#include "calibration/play_simulated.h"
#include "repertoire/repertoire.h"
#include "self_model/learned_world.h"
#include "simulation/world.h"

namespace hexapod {

/// A robot to calibrate, and how.
struct CalibrationSetting {
  std::shared_ptr<const Imagination> imagination;
  LearnedWorld learned;
  std::vector<Trial> plan;
  Engine engine = Engine::kReduced;  ///< of simulated robots
  PoseNoise noise;                   ///< of their poses
  FitOptions fit;
};

/// Calibrates a simulated robot that has this body.
Calibration calibrateSimulated(const CalibrationSetting& setting, const Physics& body,
                               std::uint64_t seed);

/// How many robots are drawn, and how many candidates are learned for what was found of each; 0:
/// none.
struct DrawOptions {
  std::int64_t draws = 10;
  std::int64_t evaluations = 0;
  std::int64_t threads = 0;
  std::uint64_t seed = 1;
};

/// Calibrates robots whose friction, servo gain, torque and mass are drawn uniformly within 30 %,
/// and prints a line of Markdown about each, and the medians. Where repertoires are learned, each
/// is chained in the drawn world, beside the one of `setting`, chained there and where it was
/// learned.
void calibrateDraws(const CalibrationSetting& setting, const Repertoire& repertoire,
                    const DrawOptions& options, std::ostream& stream);

}  // namespace hexapod
