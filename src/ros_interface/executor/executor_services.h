#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <std_srvs/Trigger.h>

#include <string>
#include <vector>

#include "execution/shared_executor.h"
#include "ros_interface/executor/joint_feedback.h"

namespace hexapod {

/// The services ~arm ~disarm ~stand ~sit, on a queue and a thread of their own: they wait for the
/// command loop.
class ExecutorServices {
 public:
  /// The references must outlive it.
  ExecutorServices(const ros::NodeHandle& private_node, SharedExecutor& executor,
                   const JointFeedback& feedback, std::vector<std::string> joint_names);

  /// The sentence of a cause, with the names of the nodes it is about.
  std::string explain(const Cause& cause) const;

 private:
  using Response = std_srvs::Trigger::Response;

  void advertise(const std::string& name, Cause (SharedExecutor::*request)());

  SharedExecutor& executor_;
  const JointFeedback& feedback_;
  std::vector<std::string> joint_names_;
  ros::CallbackQueue queue_;
  ros::NodeHandle private_node_;
  std::vector<ros::ServiceServer> services_;
  ros::AsyncSpinner spinner_;
};

}  // namespace hexapod
