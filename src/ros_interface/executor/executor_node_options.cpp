#include "ros_interface/executor/executor_node_options.h"

namespace hexapod {

std::vector<Option> declareOptions(ExecutorNodeOptions& options) {
  std::vector<Option> all = {
      option("robot_config", options.robot_config,
             "Path of the robot's YAML (legs, gait, servo, contact); its URDF is the parameter "
             "robot_description."),
      option("joint_map", options.joint_map,
             "Path of a joint map (names, signs and offsets of the servo driver); empty: names "
             "and angles of the robot description."),
      option("command_interface", options.command_interface,
             "Where commands go: joint_command (joint_state), trajectory or group position "
             "controllers, one topic per joint, or nowhere.",
             {CommandInterface::kJointState, CommandInterface::kJointTrajectory,
              CommandInterface::kJointGroupPosition, CommandInterface::kPerJoint,
              CommandInterface::kNone}),
      option("controllers", options.controllers,
             "For joint_trajectory and joint_group_position: the controller of all joints, or one "
             "per leg in the order of the description, separated by commas."),
      option("joint_topic", options.joint_topic,
             "For per_joint: the topic of a joint; {joint} stands for its name."),
      option("auto_arm", options.auto_arm,
             "Stand up by itself once after the start. The parameter is then set to false: an "
             "executor that is started again in the same session waits for ~arm."),
      option("realtime", options.realtime,
             "Ask the system for real-time priorities and locked memory, so that other programs do "
             "not make commands late; where it refuses, say so and go on."),
  };
  for (const Option& option : declareOptions(options.executor)) all.push_back(option);
  for (Option option : declarePlayingOptions(options.behavior)) {
    // Of these only the period is the executor's own.
    option.meaning += option.name == "command_period_s"
                          ? " A repertoire learned with another one is refused."
                          : " Of genomes that are played without a repertoire: it brings its own.";
    all.push_back(std::move(option));
  }
  return all;
}

}  // namespace hexapod
