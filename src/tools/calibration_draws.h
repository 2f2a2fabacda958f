#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <vector>

#include "calibration/calibration_report.h"
#include "calibration/play_simulated.h"
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

/// Calibrates robots whose friction, servo gain, torque and mass are drawn uniformly within 30 %,
/// and prints a line of Markdown about each, and the medians.
void calibrateDraws(const CalibrationSetting& setting, std::int64_t draws, std::uint64_t seed,
                    std::ostream& stream);

}  // namespace hexapod
