#pragma once

#include <string>
#include <vector>

#include "common/options.h"
#include "ros_interface/common/names.h"

namespace hexapod {

/// Where poses come from, and how long they are waited for.
struct PoseOptions {
  std::string global_frame = names::kOdomFrame;
  std::string base_frame = names::kFootprintFrame;
  double tf_timeout_s = 0.5;
  double pose_timeout_s = 1.0;
  double pose_settle_s = 0.15;
};

/// The options under their names, bound to `options`, which must outlive them.
std::vector<Option> declareOptions(PoseOptions& options);

}  // namespace hexapod
