#include "ros_interface/simulated_robot/robot_observer.h"

#include <algorithm>
#include <cmath>

#include "ros_interface/common/conversions.h"

namespace hexapod {

RobotObserver::RobotObserver(const RobotDescription& robot, const RobotFrames& frames)
    : frames_(frames),
      base_link_(frames.tf_prefix.empty() ? robot.base_link
                                          : frames.tf_prefix + "/" + robot.base_link),
      base_from_link_(Eigen::AngleAxisd(-robot.link_from_base_yaw_rad, Eigen::Vector3d::UnitZ())),
      joint_names_(robot.jointNames()),
      reported_(robot.jointCount(), true) {
  report_.odometry.header.frame_id = frames_.odom_frame;
  report_.odometry.child_frame_id = frames_.base_frame;
}

const RobotReport* RobotObserver::observe(const World& world, const ros::Time& stamp) {
  fillJoints(world);
  const Eigen::Isometry3d world_from_base = world.worldFromBase();
  const std::vector<double>& angles_rad = report_.joints.position;
  if (!world_from_base.matrix().allFinite() ||
      !std::all_of(angles_rad.begin(), angles_rad.end(),
                   [](double angle_rad) { return std::isfinite(angle_rad); })) {
    return nullptr;
  }
  report_.joints.header.stamp = stamp;
  const Pose2 odom_from_footprint = footprint(world_from_base);
  fillOdometry(odom_from_footprint, stamp);
  fillTransforms(world_from_base, odom_from_footprint, stamp);
  return &report_;
}

void RobotObserver::fillJoints(const World& world) {
  world.jointAngles(angles_rad_);
  report_.joints.name.clear();
  report_.joints.position.clear();
  for (std::size_t j = 0; j < angles_rad_.size(); ++j) {
    if (!reported_[j]) continue;
    report_.joints.name.push_back(joint_names_[j]);
    report_.joints.position.push_back(angles_rad_[j] + noise_rad_ * random_.normal());
  }
}

void RobotObserver::disturb(const RobotDescription& robot, const Disturbance& disturbance) {
  noise_rad_ = disturbance.feedback_noise_rad;
  reported_.clear();
  for (std::size_t leg = 0; leg < robot.legs.size(); ++leg) {
    const std::vector<LegState>& legs = disturbance.physics.legs;
    const bool there = legs.empty() || legs[leg].condition != LegCondition::kMissing;
    reported_.insert(reported_.end(), robot.legs[leg].segments.size(), there);
  }
}

void RobotObserver::fillOdometry(const Pose2& odom_from_footprint, const ros::Time& stamp) {
  report_.odometry.header.stamp = stamp;
  report_.odometry.pose.pose.position.x = odom_from_footprint.x_m;
  report_.odometry.pose.pose.position.y = odom_from_footprint.y_m;
  report_.odometry.pose.pose.orientation = toQuaternionMsg(
      Eigen::Quaterniond(Eigen::AngleAxisd(odom_from_footprint.yaw_rad, Eigen::Vector3d::UnitZ())));
  report_.odometry.twist.twist = geometry_msgs::Twist();
  if (last_ && stamp > last_->stamp) {
    // Velocity over the last step, in the footprint's frame.
    const Pose2 moved = inverse(last_->odom_from_footprint) * odom_from_footprint;
    const double elapsed_s = (stamp - last_->stamp).toSec();
    report_.odometry.twist.twist.linear.x = moved.x_m / elapsed_s;
    report_.odometry.twist.twist.linear.y = moved.y_m / elapsed_s;
    report_.odometry.twist.twist.angular.z = moved.yaw_rad / elapsed_s;
  }
  last_ = Footing{odom_from_footprint, stamp};
}

void RobotObserver::fillTransforms(const Eigen::Isometry3d& world_from_base, const Pose2& footprint,
                                   const ros::Time& stamp) {
  const Eigen::Isometry3d odom_from_footprint = inSpace(footprint);
  const Eigen::Isometry3d footprint_from_base = odom_from_footprint.inverse() * world_from_base;
  report_.transforms = {
      toTransformMsg(odom_from_footprint, frames_.odom_frame, frames_.base_frame, stamp),
      toTransformMsg(footprint_from_base * base_from_link_, frames_.base_frame, base_link_, stamp)};
}

}  // namespace hexapod
