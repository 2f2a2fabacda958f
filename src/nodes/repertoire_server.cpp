// Publishes a stored repertoire: topics repertoire and repertoire_markers, service get_repertoire.
#include <ros/ros.h>

#include "repertoire/repertoire_file.h"
#include "ros_interface/params.h"
#include "ros_interface/repertoire_publisher.h"

namespace hexapod {
namespace {

int serve() {
  ros::NodeHandle node;
  ros::NodeHandle private_node("~");
  std::string file;
  loadParams(private_node,
             {option("repertoire_file", file, "SQLite file written by the learner.")});
  if (file.empty()) {
    throw std::invalid_argument(
        "~repertoire_file is empty; give the path of a repertoire, e.g. repertoire_file:=gaits.db.");
  }
  RepertoirePublisher publisher(node);
  const Repertoire repertoire = loadRepertoire(expandHome(file));
  publisher.publish(repertoire);
  ROS_INFO_STREAM("Publishing " << repertoire.entries.size() << " entries of " << file << ".");
  ros::spin();
  return 0;
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  ros::init(argc, argv, "repertoire_server");
  return hexapod::runNode(hexapod::serve);
}
