#pragma once

#include <nav_msgs/Odometry.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <sensor_msgs/JointState.h>
#include <tf2_ros/transform_broadcaster.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "common/random.h"
#include "ros_interface/simulated_robot/disturbance.h"
#include "simulation/world.h"

namespace hexapod {

/// Publishes where a simulated robot is: joint_states, odom, tf odom -> base_footprint -> base, and
/// /clock when asked to. base_footprint is the projection of the base on the floor with its heading
/// (REP-120); height, roll and pitch are in base_footprint -> base.
class RobotPublisher {
 public:
  RobotPublisher(ros::NodeHandle& node, const RobotDescription& robot, bool publish_clock);

  /// The world's state at `stamp`; nothing that is not finite leaves.
  void publish(const World& world, const ros::Time& stamp);
  /// From now on reported joint angles are noisy, and joints of missing legs are left out: there is
  /// nothing that could report them.
  void disturb(const RobotDescription& robot, const Disturbance& disturbance);

  /// The next velocity is not taken from the pose before (the robot was put elsewhere).
  void forgetMotion() { last_.reset(); }

 private:
  struct Footing {
    Pose2 odom_from_footprint;
    ros::Time stamp;
  };

  void fillJoints(const World& world);
  void publishOdometry(const Pose2& odom_from_footprint, const ros::Time& stamp);
  void publishTransforms(const Eigen::Isometry3d& world_from_base, const Pose2& footprint,
                         const ros::Time& stamp);

  std::string base_link_;
  Eigen::Isometry3d base_from_link_;  // they differ where forward is not x of the link
  std::vector<std::string> joint_names_;
  std::vector<bool> reported_;  // per joint
  double noise_rad_ = 0.0;
  Random random_{2};
  std::vector<double> angles_rad_;
  sensor_msgs::JointState joints_;
  nav_msgs::Odometry odometry_;
  std::optional<Footing> last_;
  ros::Publisher joint_publisher_;
  ros::Publisher odometry_publisher_;
  ros::Publisher clock_publisher_;
  tf2_ros::TransformBroadcaster transforms_;
};

}  // namespace hexapod
