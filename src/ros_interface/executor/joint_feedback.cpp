#include "ros_interface/executor/joint_feedback.h"

#include <ros/console.h>

#include "ros_interface/common/names.h"

namespace hexapod {
namespace {

constexpr double kWarnPeriod_s = 5.0;

}  // namespace

JointFeedback::JointFeedback(ros::NodeHandle& node, SharedExecutor& executor, const JointMap& map)
    : executor_(executor),
      map_(map),
      matcher_(map.wireNames(), JointMatcher::OtherJoints::kIgnore) {
  subscriber_ = node.subscribe(names::kJointStates, 1, &JointFeedback::onJointState, this,
                               ros::TransportHints().tcpNoDelay());
}

void JointFeedback::onJointState(const sensor_msgs::JointState::ConstPtr& message) {
  if (matcher_.match(message->name, message->position)) {
    ++received_;
    map_.fromWire(matcher_.values(), angles_rad_);
    executor_.feedback(angles_rad_);
    return;
  }
  ++refused_;
  problem_ = matcher_.problem();
  ROS_WARN_STREAM_THROTTLE(
      kWarnPeriod_s, "A message on " << subscriber_.getTopic() << " is of no use: " << problem_);
}

}  // namespace hexapod
