#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <std_msgs/Bool.h>

#include <atomic>
#include <cstdint>
#include <thread>

#include "ros_interface/executor/stop_desk.h"

namespace hexapod {

/// The topic e_stop and the service ~stop (StopDesk), on a queue and a thread of their own, in
/// which nothing waits: no goal, request or other callback keeps a stop waiting. With `realtime`
/// other programs do not either: the thread has the priority of the command loop.
class EmergencyStop {
 public:
  /// `executor` must outlive it.
  EmergencyStop(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                SharedExecutor& executor, bool realtime);
  ~EmergencyStop();
  EmergencyStop(const EmergencyStop&) = delete;
  EmergencyStop& operator=(const EmergencyStop&) = delete;

  /// Publishers of e_stop at present.
  std::uint32_t publishers() const { return topic_.getNumPublishers(); }

 private:
  void run(bool realtime);
  void onEStop(const std_msgs::Bool::ConstPtr& message);

  StopDesk desk_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::NodeHandle private_node_;
  ros::Subscriber topic_;
  ros::ServiceServer service_;
  std::atomic<bool> running_{true};
  std::thread thread_;
};

}  // namespace hexapod
