#pragma once

#include <ros/node_handle.h>

#include <string>

#include "robot/robot_description.h"

namespace hexapod {

/// The robot of this ROS session: the URDF text of the parameter robot_description (relative to
/// `node`, so that a namespace has its own) and the YAML file `robot_config`.
/// Throws std::invalid_argument with sentences when one is missing or wrong.
RobotDescription robotFromParams(const ros::NodeHandle& node, const std::string& robot_config);

}  // namespace hexapod
