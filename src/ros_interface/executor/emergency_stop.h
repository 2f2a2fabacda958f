#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <std_msgs/Bool.h>

#include <cstdint>

#include "execution/shared_executor.h"

namespace hexapod {

/// The topic e_stop and the service ~stop, on a queue and a thread of their own, in which nothing
/// waits: no goal, request or other callback keeps a stop waiting.
class EmergencyStop {
 public:
  /// `executor` must outlive it.
  EmergencyStop(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                SharedExecutor& executor);

  /// Publishers of e_stop at present.
  std::uint32_t publishers() const { return topic_.getNumPublishers(); }

 private:
  void onEStop(const std_msgs::Bool::ConstPtr& message);

  SharedExecutor& executor_;
  bool pressed_ = false;  // as last heard
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::NodeHandle private_node_;
  ros::Subscriber topic_;
  ros::ServiceServer service_;
  ros::AsyncSpinner spinner_;
};

}  // namespace hexapod
