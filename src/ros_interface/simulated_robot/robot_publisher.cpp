#include "ros_interface/simulated_robot/robot_publisher.h"

#include <geometry_msgs/TransformStamped.h>
#include <rosgraph_msgs/Clock.h>

#include <algorithm>
#include <cmath>

#include "geometry/pose2.h"
#include "ros_interface/common/names.h"

namespace hexapod {
namespace {

constexpr char kOdometryTopic[] = "odom";
constexpr char kClockTopic[] = "/clock";
constexpr std::uint32_t kQueueSize = 10;

Eigen::Isometry3d inSpace(const Pose2& pose) {
  Eigen::Isometry3d isometry = Eigen::Isometry3d::Identity();
  isometry.translation() << pose.x_m, pose.y_m, 0.0;
  isometry.linear() = Eigen::AngleAxisd(pose.yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return isometry;
}

geometry_msgs::Quaternion toMsg(const Eigen::Quaterniond& rotation) {
  geometry_msgs::Quaternion message;
  message.x = rotation.x();
  message.y = rotation.y();
  message.z = rotation.z();
  message.w = rotation.w();
  return message;
}

geometry_msgs::TransformStamped toMsg(const Eigen::Isometry3d& transform, const char* parent,
                                      const std::string& child, const ros::Time& stamp) {
  geometry_msgs::TransformStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = parent;
  message.child_frame_id = child;
  message.transform.translation.x = transform.translation().x();
  message.transform.translation.y = transform.translation().y();
  message.transform.translation.z = transform.translation().z();
  message.transform.rotation = toMsg(Eigen::Quaterniond(transform.linear()).normalized());
  return message;
}

// Of twelve uniform numbers: standard deviation 1.
double normal(Random& random) {
  double sum = -6.0;
  for (int i = 0; i < 12; ++i) sum += random.uniform();
  return sum;
}

}  // namespace

RobotPublisher::RobotPublisher(ros::NodeHandle& node, const RobotDescription& robot,
                               bool publish_clock)
    : base_link_(robot.base_link),
      base_from_link_(Eigen::AngleAxisd(-robot.link_from_base_yaw_rad, Eigen::Vector3d::UnitZ())),
      joint_names_(robot.jointNames()),
      reported_(robot.jointCount(), true) {
  odometry_.header.frame_id = names::kOdomFrame;
  odometry_.child_frame_id = names::kFootprintFrame;
  joint_publisher_ = node.advertise<sensor_msgs::JointState>(names::kJointStates, kQueueSize);
  odometry_publisher_ = node.advertise<nav_msgs::Odometry>(kOdometryTopic, kQueueSize);
  if (publish_clock) {
    clock_publisher_ = node.advertise<rosgraph_msgs::Clock>(kClockTopic, kQueueSize);
  }
}

void RobotPublisher::publish(const World& world, const ros::Time& stamp) {
  fillJoints(world);
  const Eigen::Isometry3d world_from_base = world.worldFromBase();
  const bool finite = world_from_base.matrix().allFinite() &&
                      std::all_of(joints_.position.begin(), joints_.position.end(),
                                  [](double angle_rad) { return std::isfinite(angle_rad); });
  if (finite) {
    joints_.header.stamp = stamp;
    joint_publisher_.publish(joints_);
    const Pose2 odom_from_footprint = footprint(world_from_base);
    publishOdometry(odom_from_footprint, stamp);
    publishTransforms(world_from_base, odom_from_footprint, stamp);
  }
  if (!clock_publisher_) return;
  rosgraph_msgs::Clock clock;
  clock.clock = stamp;
  clock_publisher_.publish(clock);
}

void RobotPublisher::fillJoints(const World& world) {
  world.jointAngles(angles_rad_);
  joints_.name.clear();
  joints_.position.clear();
  for (std::size_t j = 0; j < angles_rad_.size(); ++j) {
    if (!reported_[j]) continue;
    joints_.name.push_back(joint_names_[j]);
    joints_.position.push_back(angles_rad_[j] + noise_rad_ * normal(random_));
  }
}

void RobotPublisher::disturb(const RobotDescription& robot, const Disturbance& disturbance) {
  noise_rad_ = disturbance.feedback_noise_rad;
  reported_.clear();
  for (std::size_t leg = 0; leg < robot.legs.size(); ++leg) {
    const std::vector<LegState>& legs = disturbance.physics.legs;
    const bool there = legs.empty() || legs[leg].condition != LegCondition::kMissing;
    reported_.insert(reported_.end(), robot.legs[leg].segments.size(), there);
  }
}

void RobotPublisher::publishOdometry(const Pose2& odom_from_footprint, const ros::Time& stamp) {
  odometry_.header.stamp = stamp;
  odometry_.pose.pose.position.x = odom_from_footprint.x_m;
  odometry_.pose.pose.position.y = odom_from_footprint.y_m;
  odometry_.pose.pose.orientation = toMsg(
      Eigen::Quaterniond(Eigen::AngleAxisd(odom_from_footprint.yaw_rad, Eigen::Vector3d::UnitZ())));
  odometry_.twist.twist = geometry_msgs::Twist();
  if (last_ && stamp > last_->stamp) {
    // Velocity over the last step, in the footprint's frame.
    const Pose2 moved = inverse(last_->odom_from_footprint) * odom_from_footprint;
    const double elapsed_s = (stamp - last_->stamp).toSec();
    odometry_.twist.twist.linear.x = moved.x_m / elapsed_s;
    odometry_.twist.twist.linear.y = moved.y_m / elapsed_s;
    odometry_.twist.twist.angular.z = moved.yaw_rad / elapsed_s;
  }
  last_ = Footing{odom_from_footprint, stamp};
  odometry_publisher_.publish(odometry_);
}

void RobotPublisher::publishTransforms(const Eigen::Isometry3d& world_from_base,
                                       const Pose2& footprint, const ros::Time& stamp) {
  const Eigen::Isometry3d odom_from_footprint = inSpace(footprint);
  const Eigen::Isometry3d footprint_from_base = odom_from_footprint.inverse() * world_from_base;
  transforms_.sendTransform(
      {toMsg(odom_from_footprint, names::kOdomFrame, names::kFootprintFrame, stamp),
       toMsg(footprint_from_base * base_from_link_, names::kFootprintFrame, base_link_, stamp)});
}

}  // namespace hexapod
