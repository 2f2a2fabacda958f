#pragma once

#include <ros/node_handle.h>

#include <atomic>
#include <string>

#include "robot/robot_description.h"

namespace hexapod {

/// What the processes with a loop of their own share, executor and simulated robot.

/// Takes over the signals, waits for a ROS master, naming it every few seconds, and starts ROS for
/// as long as the process lives. False when asked to leave meanwhile. Needs ros::init() with
/// NoSigintHandler before.
bool startProcess();

/// True once SIGINT, SIGTERM or SIGHUP came: a loop ends in order, not in the middle of a command.
const std::atomic<bool>& leaveFlag();

/// robotFromParams(), whose errors are wrong parameters here: throws std::invalid_argument.
RobotDescription requireRobot(const ros::NodeHandle& node, const std::string& robot_config);

}  // namespace hexapod
