#include "ros_interface/planner/twist_door.h"

#include <ros/console.h>

#include <cmath>

namespace hexapod {

TwistDoor::TwistDoor(const ros::NodeHandle& node, ros::CallbackQueueInterface& queue,
                     const Clock& clock, Walker& walker, double timeout_s)
    : clock_(clock), walker_(walker), timeout_ns_(secondsToNs(timeout_s)) {
  ros::NodeHandle own(node);
  own.setCallbackQueue(&queue);
  subscriber_ =
      own.subscribe("cmd_vel", 1, &TwistDoor::receive, this, ros::TransportHints().tcpNoDelay());
}

void TwistDoor::receive(const geometry_msgs::Twist::ConstPtr& message) {
  const Twist twist{message->linear.x, message->linear.y, message->angular.z};
  const double size =
      std::abs(twist.x_m_per_s) + std::abs(twist.y_m_per_s) + std::abs(twist.yaw_rad_per_s);
  if (!std::isfinite(size)) ROS_WARN("A velocity on cmd_vel is not finite; it is taken as a stop.");
  const bool moves = std::isfinite(size) && size > 0.0;
  if (!begins(moves ? std::optional<Twist>(twist) : std::nullopt)) return;
  GoalRequest request;
  request.twist = [this] { return present(); };
  GoalListener listener;
  listener.ended = [this](const WalkReport& report) { onEnd(report); };
  walker_.submit(request, listener);
}

bool TwistDoor::begins(const std::optional<Twist>& twist) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::int64_t now_ns = clock_.steadyNow_ns();
  if (!twist_ || now_ns - received_ns_ > timeout_ns_) is_barred_ = false;
  twist_ = twist;
  received_ns_ = now_ns;
  if (!twist || is_open_ || is_barred_) return false;
  is_open_ = true;
  return true;
}

std::optional<Twist> TwistDoor::present() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return clock_.steadyNow_ns() - received_ns_ > timeout_ns_ ? std::nullopt : twist_;
}

void TwistDoor::onEnd(const WalkReport& report) {
  const std::lock_guard<std::mutex> lock(mutex_);
  is_open_ = false;
  is_barred_ = !report.success();
}

}  // namespace hexapod
