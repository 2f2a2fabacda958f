// Shows a repertoire in rviz and has what is clicked there played, by the model or by the robot.
#include <ros/ros.h>

#include "ros_interface/browser/browser_node.h"
#include "ros_interface/common/node_process.h"
#include "ros_interface/common/params.h"
#include "ros_interface/common/robot_param.h"

namespace hexapod {
namespace {

int browse() {
  ros::NodeHandle node;
  ros::NodeHandle private_node("~");
  BrowserOptions options;
  loadParams(private_node, declareOptions(options));
  BrowserNode browser(node, private_node, options, robotFromParams(node, options.robot_config));
  browser.run(leaveFlag());
  return leaveInTime(0);
}

std::string optionTable() {
  BrowserOptions options;
  return describeOptions(declareOptions(options));
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  return hexapod::runNode(argc, argv, {"browser", hexapod::browse, hexapod::optionTable});
}
