// Publishes a stored repertoire: topic repertoire, services get_repertoire and ~load.
#include <ros/ros.h>

#include <exception>
#include <string>

#include "hexapod_repertoire/LoadRepertoire.h"
#include "repertoire/find_repertoire.h"
#include "repertoire/repertoire_file.h"
#include "ros_interface/common/names.h"
#include "ros_interface/common/node_process.h"
#include "ros_interface/common/params.h"
#include "ros_interface/learner/repertoire_publisher.h"

namespace hexapod {
namespace {

struct ServerOptions {
  std::string repertoire_file;
  std::string base_frame = names::kFootprintFrame;
};

std::vector<Option> declareOptions(ServerOptions& options) {
  return {option("repertoire_file", options.repertoire_file,
                 "SQLite file of a repertoire; empty: the newest ~/.ros/hexapod_repertoire*.db."),
          option("base_frame", options.base_frame, "The robot's footprint in tf.")};
}

/// Publishes the newest or the named file; returns what is published in words. Throws as
/// loadRepertoire() does, and then nothing has changed.
std::string publish(const std::string& named, RepertoirePublisher& publisher) {
  const std::string file = findRepertoire(expandHome(named), expandHome("~/.ros"));
  const Repertoire repertoire = loadRepertoire(file);
  publisher.publish(repertoire);
  std::string words =
      "Publishing " + std::to_string(repertoire.entries.size()) + " entries of " + file + ".";
  ROS_INFO_STREAM(words);
  return words;
}

int serve() {
  ros::NodeHandle node;
  ros::NodeHandle private_node("~");
  ServerOptions options;
  loadParams(private_node, declareOptions(options));
  RepertoirePublisher publisher(node, options.base_frame);
  publish(options.repertoire_file, publisher);
  using Load = hexapod_repertoire::LoadRepertoire;
  const boost::function<bool(Load::Request&, Load::Response&)> on_load =
      [&publisher](Load::Request& request, Load::Response& response) {
        try {
          response.message = publish(request.file, publisher);
          response.success = true;
        } catch (const std::exception& error) {
          response.message = error.what();
          response.success = false;
        }
        return true;
      };
  const ros::ServiceServer load = private_node.advertiseService("load", on_load);
  ros::AsyncSpinner spinner(1);
  spinner.start();
  waitUntilAskedToLeave();
  return leaveInTime(0);
}

std::string optionTable() {
  ServerOptions options;
  return describeOptions(declareOptions(options));
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  return hexapod::runNode(argc, argv, {"repertoire_server", hexapod::serve, hexapod::optionTable});
}
