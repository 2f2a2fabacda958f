#pragma once

#include <ros/callback_queue.h>
#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include "ros_interface/common/clock.h"
#include "ros_interface/robot_client/transform_gate.h"

namespace hexapod {

/// Hears /tf and /tf_static into a buffer, in a thread of its own; what the gate refuses is left
/// out with a warning. Empties the buffer when ROS time is turned back, as tf2_ros does.
class TransformEars {
 public:
  /// Both must outlive it.
  TransformEars(const Clock& clock, tf2::BufferCore& buffer);

 private:
  using Event = ros::MessageEvent<tf2_msgs::TFMessage const>;

  void hear(const Event& event, bool is_static);
  void emptyIfTimeWasTurnedBack();

  const Clock& clock_;
  tf2::BufferCore& buffer_;
  TransformGate gate_;  // thread of the queue, as the next
  ros::Time heard_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::Subscriber moving_;
  ros::Subscriber static_;
  ros::AsyncSpinner spinner_;
};

}  // namespace hexapod
