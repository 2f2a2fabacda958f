// Learns a repertoire of gaits in simulation and publishes it.
#include <ros/ros.h>

#include "ros_interface/learner.h"
#include "ros_interface/params.h"

namespace hexapod {
namespace {

int learn() {
  ros::NodeHandle node;
  ros::NodeHandle private_node("~");
  LearnerOptions options;
  loadParams(private_node, declareOptions(options));
  options.learn.repertoire_file = expandHome(options.learn.repertoire_file);
  Learner learner(node, private_node, options);
  ros::AsyncSpinner spinner(1);
  spinner.start();
  const bool finished = learner.run();
  if (finished && !options.exit_when_done) ros::waitForShutdown();
  return 0;
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  ros::init(argc, argv, "learner");
  return hexapod::runNode(hexapod::learn);
}
