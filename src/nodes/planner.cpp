// Plans chains of repertoire entries to goal poses and has the executor walk them.
#include <ros/ros.h>

#include "ros_interface/common/node_process.h"
#include "ros_interface/common/params.h"
#include "ros_interface/planner/walk_interfaces.h"

namespace hexapod {
namespace {

// Callbacks plan for up to planning_time_s; others must not wait for them.
constexpr std::uint32_t kThreads = 3;

int plan() {
  ros::NodeHandle node;
  ros::NodeHandle private_node("~");
  PlannerNodeOptions options;
  loadParams(private_node, declareOptions(options));
  Walker walker(node, private_node, options);
  const WalkInterfaces interfaces(node, private_node, walker, options);
  ros::AsyncSpinner spinner(kThreads);
  spinner.start();
  waitUntilAskedToLeave();
  return 0;
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
