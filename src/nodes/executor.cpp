// Plays behaviours on the robot, one joint command every period.
#include <ros/ros.h>
#include <sys/mman.h>
#include <unistd.h>

#include "ros_interface/executor_node.h"
#include "ros_interface/executor_process.h"
#include "ros_interface/params.h"

namespace hexapod {
namespace {

// Not 0, so that roslaunch or a supervisor knows to restart it.
constexpr int kMasterLostExitCode = 3;

int execute() {
  if (!startProcess()) return 0;
  ros::NodeHandle node;
  ros::NodeHandle private_node("~");
  ExecutorNodeOptions options;
  loadParams(private_node, declareOptions(options));
  ExecutorNode executor(node, private_node, options, requireRobot(node, options.robot_config));
  // Page faults would make the command loop late; only root may lock all it will ever map.
  if (geteuid() == 0) mlockall(MCL_CURRENT | MCL_FUTURE);
  const ExecutorNode::End end = executor.run(leaveFlag());
  if (end == ExecutorNode::End::kAskedToLeave) return 0;
  ROS_FATAL("The ROS master is gone or was replaced; the executor leaves and must be restarted.");
  return kMasterLostExitCode;
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  ros::init(argc, argv, "executor", ros::init_options::NoSigintHandler);
  return hexapod::runNode(hexapod::execute);
}
