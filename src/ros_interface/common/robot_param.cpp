#include "ros_interface/common/robot_param.h"

#include <ros/console.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "robot/load_robot.h"
#include "ros_interface/common/params.h"

namespace hexapod {

RobotDescription robotFromParams(const ros::NodeHandle& node, const std::string& robot_config) {
  const std::string name = node.resolveName("robot_description");
  std::string urdf;
  if (!node.getParam("robot_description", urdf) || urdf.empty()) {
    throw std::invalid_argument("The parameter " + name +
                                " is missing; load the robot's URDF into it, e.g. <param "
                                "name=\"robot_description\" textfile=\"urdf/hexapod.urdf\"/>.");
  }
  if (robot_config.empty()) {
    throw std::invalid_argument(
        "The parameter ~robot_config is missing; give the path of the robot's YAML, e.g. "
        "config/hexapod.yaml.");
  }
  const std::string path = expandHome(robot_config);
  std::ifstream stream(path);
  std::stringstream yaml;
  yaml << stream.rdbuf();
  if (!stream) {
    throw std::invalid_argument(path +
                                " cannot be read; ~robot_config expects the robot's YAML file.");
  }
  try {
    RobotDescription robot = parseRobot(urdf, yaml.str(), name, path);
    for (const std::string& remark : robot.remarks) ROS_WARN_STREAM(remark);
    return robot;
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument(error.what());
  }
}

}  // namespace hexapod
