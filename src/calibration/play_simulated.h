#pragma once

#include <vector>

#include "calibration/trial_file.h"
#include "common/random.h"
#include "gait/behavior_options.h"
#include "simulation/world.h"

namespace hexapod {

/// How well poses are measured: standard deviations.
struct PoseNoise {
  double position_m = 0.0;  ///< per axis
  double heading_rad = 0.0;
};

/// Plays planned trials one after another with a simulated robot, from its stand. A robot that fell
/// is stood up again, and the trial is left out.
std::vector<Trial> playSimulated(World& world, const BehaviorOptions& behavior,
                                 const std::vector<Trial>& planned, const PoseNoise& noise,
                                 Random& random);

}  // namespace hexapod
