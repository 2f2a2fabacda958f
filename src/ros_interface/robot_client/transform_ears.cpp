#include "ros_interface/robot_client/transform_ears.h"

#include <ros/console.h>

namespace hexapod {
namespace {

constexpr std::uint32_t kTransformQueue = 100;
constexpr double kWarnPeriod_s = 5.0;

}  // namespace

TransformEars::TransformEars(const Clock& clock, tf2::BufferCore& buffer)
    : clock_(clock), buffer_(buffer), spinner_(1, &queue_) {
  node_.setCallbackQueue(&queue_);
  const auto listen = [this](const std::string& topic, bool is_static) {
    return node_.subscribe<tf2_msgs::TFMessage>(
        topic, kTransformQueue,
        boost::function<void(const Event&)>(
            [this, is_static](const Event& event) { hear(event, is_static); }));
  };
  moving_ = listen("/tf", false);
  static_ = listen("/tf_static", true);
  spinner_.start();
}

void TransformEars::hear(const Event& event, bool is_static) {
  emptyIfTimeWasTurnedBack();
  const TransformGate::Source source{event.getPublisherName(), is_static, clock_.steadyNow_ns()};
  for (const geometry_msgs::TransformStamped& transform : event.getConstMessage()->transforms) {
    const std::string problem = gate_.whyRefused(transform, source);
    if (problem.empty()) {
      buffer_.setTransform(transform, source.node, is_static);
    } else {
      ROS_WARN_STREAM_THROTTLE(kWarnPeriod_s, problem);
    }
  }
}

void TransformEars::emptyIfTimeWasTurnedBack() {
  const ros::Time now = clock_.rosNow();
  if (now < heard_) {
    ROS_WARN("ROS time was turned back; what tf said before is forgotten.");
    buffer_.clear();
  }
  heard_ = now;
}

}  // namespace hexapod
