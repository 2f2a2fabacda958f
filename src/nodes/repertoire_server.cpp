// Publishes a stored repertoire: topic repertoire, service get_repertoire.
#include <ros/ros.h>

#include "repertoire/find_repertoire.h"
#include "repertoire/repertoire_file.h"
#include "ros_interface/common/node_process.h"
#include "ros_interface/common/params.h"
#include "ros_interface/learner/repertoire_publisher.h"

namespace hexapod {
namespace {

std::vector<Option> declareOptions(std::string& file) {
  return {option("repertoire_file", file,
                 "SQLite file of a repertoire; empty: the newest ~/.ros/hexapod_repertoire*.db.")};
}

int serve() {
  ros::NodeHandle node;
  ros::NodeHandle private_node("~");
  std::string file;
  loadParams(private_node, declareOptions(file));
  file = findRepertoire(expandHome(file), expandHome("~/.ros"));
  RepertoirePublisher publisher(node);
  const Repertoire repertoire = loadRepertoire(file);
  publisher.publish(repertoire);
  ROS_INFO_STREAM("Publishing " << repertoire.entries.size() << " entries of " << file << ".");
  ros::AsyncSpinner spinner(1);
  spinner.start();
  waitUntilAskedToLeave();
  return leaveInTime(0);
}

std::string optionTable() {
  std::string file;
  return describeOptions(declareOptions(file));
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  return hexapod::runNode(argc, argv, {"repertoire_server", hexapod::serve, hexapod::optionTable});
}
