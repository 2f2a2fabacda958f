#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>

#include <string>
#include <vector>

#include "execution/shared_executor.h"

namespace hexapod {

/// The topic e_stop and the services ~stop ~arm ~disarm ~stand ~sit, on a queue and threads of
/// their own: no other callback keeps a stop waiting.
class ExecutorServices {
 public:
  /// `executor` must outlive it.
  ExecutorServices(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                   SharedExecutor& executor, std::vector<std::string> joint_names);

  /// Publishers of e_stop at present.
  std::uint32_t eStopPublishers() const { return e_stop_.getNumPublishers(); }

 private:
  using Response = std_srvs::Trigger::Response;

  void advertise(const std::string& name, Cause (SharedExecutor::*request)());
  void onEStop(const std_msgs::Bool::ConstPtr& message);

  SharedExecutor& executor_;
  std::vector<std::string> joint_names_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::NodeHandle private_node_;
  ros::Subscriber e_stop_;
  std::vector<ros::ServiceServer> services_;
  ros::AsyncSpinner spinner_;
};

}  // namespace hexapod
