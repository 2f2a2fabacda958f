// Plays behaviours on the robot, one joint command every period.
#include <ros/ros.h>

#include "ros_interface/common/node_process.h"
#include "ros_interface/common/params.h"
#include "ros_interface/common/realtime.h"
#include "ros_interface/common/robot_param.h"
#include "ros_interface/executor/executor_node.h"

namespace hexapod {
namespace {

// Not 0, so that roslaunch or a supervisor knows to restart it.
constexpr int kMasterLostExitCode = 3;

int execute() {
  ros::NodeHandle node;
  ros::NodeHandle private_node("~");
  ExecutorNodeOptions options;
  loadParams(private_node, declareOptions(options));
  ExecutorNode executor(node, private_node, options, robotFromParams(node, options.robot_config));
  const std::string problem = options.realtime ? lockMemory() : "";
  if (!problem.empty()) ROS_WARN_STREAM(problem);
  const ExecutorNode::End end = executor.run(leaveFlag());
  const bool master_lost = end == ExecutorNode::End::kMasterLost;
  if (master_lost) {
    ROS_FATAL("The ROS master is gone or was replaced; the executor leaves and must be restarted.");
  }
  return leaveInTime(master_lost ? kMasterLostExitCode : 0);
}

std::string optionTable() {
  ExecutorNodeOptions options;
  return describeOptions(declareOptions(options));
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  return hexapod::runNode(argc, argv, {"executor", hexapod::execute, hexapod::optionTable});
}
