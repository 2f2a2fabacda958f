#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <tf2_ros/transform_broadcaster.h>

#include "ros_interface/simulated_robot/robot_observer.h"

namespace hexapod {

/// Publishes where a simulated robot is: joint_states, odom, tf, and /clock when asked to.
class RobotPublisher {
 public:
  RobotPublisher(ros::NodeHandle& node, bool publish_clock);

  /// What was seen at `stamp`; nullptr: nothing but /clock.
  void publish(const RobotReport* report, const ros::Time& stamp);

 private:
  ros::Publisher joint_publisher_;
  ros::Publisher odometry_publisher_;
  ros::Publisher clock_publisher_;
  tf2_ros::TransformBroadcaster transforms_;
};

}  // namespace hexapod
