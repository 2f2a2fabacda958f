#include "ros_interface/browser/model_player.h"

#include <ros/console.h>
#include <sensor_msgs/JointState.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "ros_interface/browser/entry_recording.h"
#include "ros_interface/common/conversions.h"
#include "ros_interface/common/names.h"
#include "simulation/kinematics.h"

namespace hexapod {
namespace {

constexpr double kStandingPeriod_s = 0.1;
constexpr double kPause_s = 1.0;

RecordedPose standing(const RobotDescription& robot) {
  RecordedPose pose;
  pose.world_from_base = Eigen::Translation3d(0.0, 0.0, standingHeight(robot));
  pose.angles_rad = robot.neutralPose();
  return pose;
}

}  // namespace

ModelPlayer::ModelPlayer(ros::NodeHandle& node, const RobotDescription& robot, const Clock& clock,
                         Frames frames)
    : robot_(robot),
      clock_(clock),
      frames_(std::move(frames)),
      standing_(standing(robot)),
      joint_publisher_(node.advertise<sensor_msgs::JointState>(names::kJointStates, 10)),
      thread_(&ModelPlayer::work, this) {}

ModelPlayer::~ModelPlayer() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    leaves_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void ModelPlayer::play(const LearnedWorld& learned, const Genome& genome) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    next_ = Order{learned, genome};
  }
  changed_.notify_all();
}

bool ModelPlayer::isOutdated() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return next_ || leaves_;
}

void ModelPlayer::work() {
  std::optional<Order> order;
  Recording recording;
  for (;;) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (leaves_) return;
      if (next_) {
        order = std::exchange(next_, std::nullopt);
        recording = {};
      }
    }
    if (!order) {
      hold(standing_, {}, kStandingPeriod_s);
      continue;
    }
    try {
      if (recording.poses.empty()) recording = recordEntry(robot_, order->learned, order->genome);
      show(recording, order->learned.behavior.command_period_s);
    } catch (const std::exception& error) {
      ROS_ERROR_STREAM("The behaviour cannot be shown: " << error.what());
      order.reset();
    }
  }
}

bool ModelPlayer::show(const Recording& recording, double period_s) {
  if (!hold(standing_, {}, 0.5 * kPause_s)) return false;
  for (const RecordedPose& pose : recording.poses) {
    if (!hold(pose, recording.world_from_start, period_s)) return false;
  }
  return recording.poses.empty() ||
         hold(recording.poses.back(), recording.world_from_start, kPause_s);
}

bool ModelPlayer::hold(const RecordedPose& pose, const Pose2& world_from_start, double duration_s) {
  const std::int64_t end_ns = clock_.steadyNow_ns() + secondsToNs(duration_s);
  do {
    if (isOutdated()) return false;
    publish(pose, world_from_start);
    clock_.sleepUntil(std::min(end_ns, clock_.steadyNow_ns() + secondsToNs(kStandingPeriod_s)));
  } while (clock_.steadyNow_ns() < end_ns);
  return true;
}

void ModelPlayer::publish(const RecordedPose& pose, const Pose2& world_from_start) {
  const ros::Time now = clock_.rosNow();
  sensor_msgs::JointState joints;
  joints.header.stamp = now;
  joints.name = robot_.jointNames();
  joints.position = pose.angles_rad;
  joint_publisher_.publish(joints);
  const Eigen::Isometry3d base_from_link(
      Eigen::AngleAxisd(-robot_.link_from_base_yaw_rad, Eigen::Vector3d::UnitZ()));
  const Eigen::Isometry3d start_from_base =
      inSpace(world_from_start).inverse() * pose.world_from_base;
  transforms_.sendTransform(
      {toTransformMsg(Eigen::Isometry3d::Identity(), frames_.global, frames_.base, now),
       toTransformMsg(start_from_base * base_from_link, frames_.base, robot_.base_link, now)});
}

}  // namespace hexapod
