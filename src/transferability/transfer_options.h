#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/options.h"

namespace hexapod {

/// How much, and how often, learning asks a robot.
struct TransferOptions {
  bool transferability = false;
  std::int64_t trials = 40;         ///< on the robot, in all
  std::int64_t trials_at_once = 4;  ///< one after another between two generations
  std::int64_t trial_period = 5;    ///< generations from one such series to the next
  double disparity_weight_rad_per_m = 4.0;
  std::string robot_body;  ///< of a simulated robot in place of a real one; empty: none
};

/// The options under their names, bound to `options`, which must outlive them.
std::vector<Option> declareOptions(TransferOptions& options);

}  // namespace hexapod
