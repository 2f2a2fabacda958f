// A robot in a simulated world, behind the topics of a real one.
#include <ros/ros.h>

#include "ros_interface/executor_process.h"
#include "ros_interface/params.h"
#include "ros_interface/simulated_robot_node.h"

namespace hexapod {
namespace {

int simulate() {
  if (!startProcess()) return 0;
  ros::NodeHandle node;
  ros::NodeHandle private_node("~");
  SimulatedRobotOptions options;
  loadParams(private_node, declareOptions(options));
  checkTime(options, ros::Time::isSimTime());
  SimulatedRobotNode robot(node, private_node, options, requireRobot(node, options.robot_config));
  robot.run(leaveFlag());
  return 0;
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  ros::init(argc, argv, "simulated_robot", ros::init_options::NoSigintHandler);
  return hexapod::runNode(hexapod::simulate);
}
