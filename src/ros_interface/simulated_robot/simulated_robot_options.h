#pragma once

#include <string>
#include <vector>

#include "common/options.h"
#include "ros_interface/simulated_robot/disturbance.h"
#include "ros_interface/simulated_robot/robot_observer.h"

namespace hexapod {

/// Everything the simulated robot reads from its private parameters.
struct SimulatedRobotOptions {
  std::string robot_config;  ///< path
  std::string engine = "ode";
  double real_time_factor = 1.0;  ///< 0: as fast as it can
  bool publish_clock = false;
  double command_latency_s = 0.060;
  bool realtime = true;
  RobotFrames frames;
  std::string body;         ///< as bodyFromText()
  Disturbance disturbance;  ///< from the start
};

/// The options under their names, bound to `options`, which must outlive them.
std::vector<Option> declareOptions(SimulatedRobotOptions& options);

/// Throws std::invalid_argument when time would run at two speeds: a factor other than 1 without
/// publish_clock, or /use_sim_time and publish_clock not both or neither.
void checkTime(const SimulatedRobotOptions& options, bool use_sim_time);

}  // namespace hexapod
