// Publishes a stored repertoire: topic repertoire, services get_repertoire, ~load
// and ~exclude.
#include <ros/ros.h>

#include <cstddef>
#include <exception>
#include <functional>
#include <string>

#include "hexapod_repertoire/ExcludeEntry.h"
#include "hexapod_repertoire/LoadRepertoire.h"
#include "repertoire/exclusion.h"
#include "repertoire/find_repertoire.h"
#include "repertoire/repertoire_file.h"
#include "repertoire/repertoire_writer.h"
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

/// Publishes a file, another one when asked to, and leaves out what is not to be used.
class RepertoireServer {
 public:
  /// Throws as loadRepertoire() does.
  RepertoireServer(ros::NodeHandle& node, ros::NodeHandle& private_node,
                   const ServerOptions& options)
      : publisher_(node, options.base_frame) {
    publish(options.repertoire_file);
    load_ = private_node.advertiseService("load", &RepertoireServer::onLoad, this);
    exclude_ = private_node.advertiseService("exclude", &RepertoireServer::onExclude, this);
  }

 private:
  /// The newest or the named file; returns what is published in words. When it throws nothing has
  /// changed.
  std::string publish(const std::string& named) {
    const std::string file = findRepertoire(expandHome(named), expandHome("~/.ros"));
    const Repertoire stored = loadRepertoire(file);
    const Repertoire used = withoutExcluded(stored);
    publisher_.publish(used);
    file_ = file;
    std::string words = "Publishing " + std::to_string(used.entries.size()) + " entries of " + file;
    const std::size_t left_out = stored.entries.size() - used.entries.size();
    if (left_out > 0) words += ", without " + std::to_string(left_out) + " that are not to be used";
    words += ".";
    ROS_INFO_STREAM(words);
    return words;
  }

  template <class Response>
  static bool answer(Response& response, const std::function<std::string()>& act) {
    try {
      response.message = act();
      response.success = true;
    } catch (const std::exception& error) {
      response.message = error.what();
      response.success = false;
    }
    return true;
  }

  bool onLoad(hexapod_repertoire::LoadRepertoire::Request& request,
              hexapod_repertoire::LoadRepertoire::Response& response) {
    return answer(response, [&] { return publish(request.file); });
  }

  bool onExclude(hexapod_repertoire::ExcludeEntry::Request& request,
                 hexapod_repertoire::ExcludeEntry::Response& response) {
    return answer(response, [&] {
      StoredRepertoire stored = loadStoredRepertoire(file_);
      setExcluded(stored.repertoire, request.entry_id, request.exclude != 0);
      saveRepertoire(file_, stored.repertoire, stored.learner_state);
      return publish(file_);
    });
  }

  RepertoirePublisher publisher_;
  std::string file_;
  ros::ServiceServer load_;
  ros::ServiceServer exclude_;
};

int serve() {
  ros::NodeHandle node;
  ros::NodeHandle private_node("~");
  ServerOptions options;
  loadParams(private_node, declareOptions(options));
  const RepertoireServer server(node, private_node, options);
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
