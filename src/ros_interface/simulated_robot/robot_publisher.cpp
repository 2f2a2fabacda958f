#include "ros_interface/simulated_robot/robot_publisher.h"

#include <rosgraph_msgs/Clock.h>

#include "ros_interface/common/names.h"

namespace hexapod {
namespace {

constexpr char kOdometryTopic[] = "odom";
constexpr char kClockTopic[] = "/clock";
constexpr std::uint32_t kQueueSize = 10;

}  // namespace

RobotPublisher::RobotPublisher(ros::NodeHandle& node, bool publish_clock)
    : joint_publisher_(node.advertise<sensor_msgs::JointState>(names::kJointStates, kQueueSize)),
      odometry_publisher_(node.advertise<nav_msgs::Odometry>(kOdometryTopic, kQueueSize)) {
  if (publish_clock) {
    clock_publisher_ = node.advertise<rosgraph_msgs::Clock>(kClockTopic, kQueueSize);
  }
}

void RobotPublisher::publish(const RobotReport* report, const ros::Time& stamp) {
  if (report != nullptr) {
    joint_publisher_.publish(report->joints);
    odometry_publisher_.publish(report->odometry);
    transforms_.sendTransform(report->transforms);
  }
  if (!clock_publisher_) return;
  rosgraph_msgs::Clock clock;
  clock.clock = stamp;
  clock_publisher_.publish(clock);
}

}  // namespace hexapod
