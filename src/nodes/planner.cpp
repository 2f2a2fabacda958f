// Plans chains of repertoire entries to goal poses and has the executor walk them.
#include <ros/ros.h>

#include "ros_interface/common/node_process.h"
#include "ros_interface/common/params.h"
#include "ros_interface/common/robot_param.h"
#include "ros_interface/planner/planner_node.h"

namespace hexapod {
namespace {

// Not 0, so that roslaunch or a supervisor knows to restart it.
constexpr int kMasterLostExitCode = 3;

int plan() {
  ros::NodeHandle node;
  ros::NodeHandle private_node("~");
  PlannerNodeOptions options;
  loadParams(private_node, declareOptions(options));
  checkOptions(options);
  std::optional<RobotDescription> robot;
  if (!options.robot_config.empty()) robot = robotFromParams(node, options.robot_config);
  PlannerNode planner(node, private_node, options, robot);
  const PlannerNode::End end = planner.run(leaveFlag());
  const bool master_lost = end == PlannerNode::End::kMasterLost;
  if (master_lost) {
    ROS_FATAL("The ROS master is gone or was replaced; the planner leaves and must be restarted.");
  }
  return leaveInTime(master_lost ? kMasterLostExitCode : 0);
}

std::string optionTable() {
  PlannerNodeOptions options;
  return describeOptions(declareOptions(options));
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  return hexapod::runNode(argc, argv, {"planner", hexapod::plan, hexapod::optionTable});
}
