#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/options.h"
#include "execution/command_gate.h"

namespace hexapod {

/// What arming does when the robot is far from the neutral pose: choices of the option far_start.
struct FarStart {
  static constexpr const char* kRamp = "ramp";
  static constexpr const char* kRefuse = "refuse";
};

/// How the executor stands up, watches the robot and breaks off.
struct ExecutorOptions {
  double feedback_timeout_s = 0.5;          ///< 0: open loop, joint states are not looked at
  double start_tolerance_rad = 0.2;         ///< largest distance from neutral that is no far start
  std::string far_start = FarStart::kRamp;  ///< one of FarStart
  double ramp_time_s = 2.0;                 ///< shortest ramp to or from the neutral pose
  double hold_time_s = 0.2;                 ///< last command held when a behaviour is broken off
  double max_tracking_error_rad = 0.5;      ///< 0: not watched
  double tracking_timeout_s = 0.5;          ///< how long a joint may be further off
  std::int64_t max_dead_legs = 2;  ///< legs that may be believed dead or in doubt; 0: none ever
  std::string dead_legs;           ///< legs that are not there, names with commas between them
  double belief_patience_s = 3.0;  ///< for a leg in doubt, after the behaviour that shows it
  double sit_signal = 1.0;         ///< second control signal of the sitting pose, see sittingPose()
  double e_stop_timeout_s = 0;     ///< longest silence of the emergency stop's publisher; 0: any
  bool hold_on_stop = false;       ///< a stop sends one last command: stay where you are
  GateOptions gate;
};

/// The options under their names, bound to `options`, which must outlive them.
std::vector<Option> declareOptions(ExecutorOptions& options);

}  // namespace hexapod
