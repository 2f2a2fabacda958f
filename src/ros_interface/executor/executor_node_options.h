#pragma once

#include <string>
#include <vector>

#include "common/options.h"
#include "execution/executor_options.h"
#include "gait/behavior_options.h"

namespace hexapod {

/// Where commands go: choices of the option command_interface.
struct CommandInterface {
  static constexpr const char* kJointState = "joint_state";
  static constexpr const char* kJointTrajectory = "joint_trajectory";
  static constexpr const char* kJointGroupPosition = "joint_group_position";
  static constexpr const char* kPerJoint = "per_joint";
  static constexpr const char* kNone = "none";
};

/// Everything the executor node reads from its private parameters.
struct ExecutorNodeOptions {
  std::string robot_config;  ///< path
  std::string joint_map;     ///< path; empty: names and angles go out as they are
  std::string command_interface = CommandInterface::kJointState;
  std::string controllers = "position_controller";  ///< comma-separated
  std::string joint_topic = "{joint}_position_controller/command";
  bool auto_arm = false;
  bool realtime = true;
  ExecutorOptions executor;
  BehaviorOptions behavior;  ///< always within the velocity limits
};

/// The options under their names, bound to `options`, which must outlive them.
std::vector<Option> declareOptions(ExecutorNodeOptions& options);

}  // namespace hexapod
