#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>

#include <mutex>
#include <string>

#include "hexapod_repertoire/GetRepertoire.h"
#include "hexapod_repertoire/Repertoire.h"
#include "repertoire/repertoire.h"

namespace hexapod {

/// Offers a repertoire to everybody: the latched topic `repertoire` and the service
/// `get_repertoire`. Callable from any thread.
class RepertoirePublisher {
 public:
  /// `base_frame`: the frame that behaviours start in, for the message.
  RepertoirePublisher(ros::NodeHandle& node, std::string base_frame);

  /// Publishes and keeps the repertoire for the service.
  void publish(const Repertoire& repertoire);

 private:
  bool answer(hexapod_repertoire::GetRepertoire::Request& request,
              hexapod_repertoire::GetRepertoire::Response& response);

  std::string base_frame_;
  ros::Publisher repertoire_publisher_;
  ros::ServiceServer service_;
  std::mutex mutex_;
  hexapod_repertoire::Repertoire latest_;  // guarded by mutex_
  bool published_ = false;                 // guarded by mutex_
};

}  // namespace hexapod
