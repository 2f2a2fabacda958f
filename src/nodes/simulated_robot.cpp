// A robot in a simulated world, behind the topics of a real one.
#include <ros/ros.h>

#include "ros_interface/common/node_process.h"
#include "ros_interface/common/params.h"
#include "ros_interface/common/robot_param.h"
#include "ros_interface/simulated_robot/simulated_robot_node.h"

namespace hexapod {
namespace {

int simulate() {
  ros::NodeHandle node;
  ros::NodeHandle private_node("~");
  SimulatedRobotOptions options;
  loadParams(private_node, declareOptions(options));
  checkTime(options, ros::Time::isSimTime());
  SimulatedRobotNode robot(node, private_node, options,
                           robotFromParams(node, options.robot_config));
  robot.run(leaveFlag());
  return leaveInTime(0);
}

std::string optionTable() {
  SimulatedRobotOptions options;
  return describeOptions(declareOptions(options));
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  return hexapod::runNode(argc, argv, {"simulated_robot", hexapod::simulate, hexapod::optionTable});
}
