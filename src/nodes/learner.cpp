// Learns a repertoire of gaits in simulation and publishes it.
#include <ros/ros.h>

#include <filesystem>

#include "ros_interface/common/node_process.h"
#include "ros_interface/common/params.h"
#include "ros_interface/learner/learner_node.h"

namespace hexapod {
namespace {

int learn() {
  ros::NodeHandle node;
  ros::NodeHandle private_node("~");
  LearnerOptions options;
  loadParams(private_node, declareOptions(options));
  std::string& file = options.learn.repertoire_file;
  if (!file.empty()) file = std::filesystem::absolute(expandHome(file)).string();
  LearnerNode learner(node, private_node, options);
  ros::AsyncSpinner spinner(1);
  spinner.start();
  saveBeforeLeaving();
  const int code = leaveInTime(learner.run());
  leaveLastWords(learner.lastWords());
  return code;
}

std::string optionTable() {
  LearnerOptions options;
  return describeOptions(declareOptions(options));
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  return hexapod::runNode(argc, argv, {"learner", hexapod::learn, hexapod::optionTable});
}
