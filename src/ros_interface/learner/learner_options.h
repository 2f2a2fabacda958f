#pragma once

#include <string>
#include <vector>

#include "common/options.h"
#include "learning/learn_options.h"
#include "ros_interface/robot_client/pose_options.h"

namespace hexapod {

/// Options of the learner node: those of the run, and how it is published.
struct LearnerOptions {
  LearnOptions learn;
  std::string robot_config;
  double publish_period_s = 10.0;
  bool exit_when_done = false;
  bool start_paused = false;
  PoseOptions pose;  ///< of the robot that entries are tried on; base_frame for all else, too
};

/// The options under their names, bound to `options`, which must outlive them.
std::vector<Option> declareOptions(LearnerOptions& options);

}  // namespace hexapod
