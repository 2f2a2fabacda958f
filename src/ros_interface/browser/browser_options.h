#pragma once

#include <string>
#include <vector>

#include "common/options.h"
#include "ros_interface/robot_client/pose_options.h"

namespace hexapod {

/// Who plays the behaviour that was clicked: the choices of the option player.
struct Player {
  static constexpr const char* kModel = "model";  ///< the model in rviz, by simulation
  static constexpr const char* kRobot = "robot";  ///< the robot, by its executor
};

/// Options of the browser.
struct BrowserOptions {
  std::string robot_config;  ///< path
  std::string player = Player::kModel;
  bool play_best = false;  ///< with player model: while nothing has been clicked
  PoseOptions pose;
};

/// The options under their names, bound to `options`, which must outlive them.
std::vector<Option> declareOptions(BrowserOptions& options);

}  // namespace hexapod
