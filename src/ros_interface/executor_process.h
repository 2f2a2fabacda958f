#pragma once

#include <ros/node_handle.h>

#include <atomic>
#include <string>

#include "robot/robot_description.h"

namespace hexapod {

/// What the processes with a loop of their own share, executor and simulated robot.

/// ros::init with our own signals: SIGINT and SIGTERM set leaveFlag(), so that a loop ends in order
/// instead of in the middle of a command.
void initProcess(int argc, char** argv, const std::string& name);

/// True once the process was asked to leave.
const std::atomic<bool>& leaveFlag();

/// Waits for a ROS master and names it every few seconds. False when asked to leave meanwhile.
bool waitForMaster();

/// robotFromParams(), whose errors are wrong parameters here: throws std::invalid_argument.
RobotDescription requireRobot(const ros::NodeHandle& node, const std::string& robot_config);

}  // namespace hexapod
