#include "ros_interface/executor/joint_feedback.h"

#include <ros/console.h>

#include <utility>

#include "ros_interface/common/names.h"
#include "ros_interface/common/realtime.h"

namespace hexapod {
namespace {

constexpr double kWarnPeriod_s = 5.0;
// Room for the drivers of all legs while the thread is busy with the first.
constexpr std::uint32_t kFeedbackQueue = 10;
// How old a reset may be in open loop.
constexpr double kFresh_s = 1.0;

}  // namespace

JointFeedback::JointFeedback(const ros::NodeHandle& node, SharedExecutor& executor,
                             const JointMap& map, double timeout_s, const Clock& clock,
                             bool realtime)
    : executor_(executor),
      map_(map),
      clock_(clock),
      realtime_(realtime),
      merger_(map.wireNames(), timeout_s > 0.0 ? timeout_s : kFresh_s),
      readings_(map.joints().size()),
      ranges_(map.joints().size()),
      node_(node),
      spinner_(1, &queue_) {
  node_.setCallbackQueue(&queue_);
  if (timeout_s > 0.0) {
    subscriber_ = node_.subscribe<sensor_msgs::JointState>(
        names::kJointStates, kFeedbackQueue,
        boost::function<void(const Event&)>([this](const Event& event) { onJointState(event); }),
        ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  }
  reset_subscriber_ = node_.subscribe<std_msgs::Header>(
      names::kRobotReset, kFeedbackQueue,
      boost::function<void(const ros::MessageEvent<const std_msgs::Header>&)>(
          [this](const ros::MessageEvent<const std_msgs::Header>& event) { onReset(event); }),
      ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  spinner_.start();
}

std::string JointFeedback::problem() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return problem_;
}

std::string JointFeedback::rivals() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return rivals_;
}

std::optional<std::int64_t> JointFeedback::takeReset() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(reset_ns_, std::nullopt);
}

void JointFeedback::onReset(const ros::MessageEvent<const std_msgs::Header>& event) {
  const auto reset_ns =
      merger_.timeOf(event.getPublisherName(), toNs(event.getConstMessage()->stamp),
                     {toNs(clock_.rosNow()), clock_.robotNow_ns()});
  if (!reset_ns) {
    ROS_WARN_STREAM_THROTTLE(kWarnPeriod_s, "A message on "
                                                << reset_subscriber_.getTopic()
                                                << " is left out: " << merger_.problem());
    return;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  reset_ns_ = reset_ns;
}

void JointFeedback::onJointState(const Event& event) {
  if (thread_local bool asked = false; realtime_ && !asked) {
    asked = true;
    askForRealtimePriority(RealtimePriority::kFeedback);
  }
  const sensor_msgs::JointState& message = *event.getConstMessage();
  const FeedbackMerger::Result result =
      merger_.add({message.name,
                   message.position,
                   toNs(message.header.stamp),
                   event.getPublisherName(),
                   {toNs(clock_.rosNow()), clock_.robotNow_ns()}});
  if (result == FeedbackMerger::Result::kRefused) {
    ++refused_;
    const std::lock_guard<std::mutex> lock(mutex_);
    problem_ = merger_.problem();
    ROS_WARN_STREAM_THROTTLE(
        kWarnPeriod_s, "A message on " << subscriber_.getTopic() << " is of no use: " << problem_);
    return;
  }
  if (result == FeedbackMerger::Result::kUsed) ++received_;
  handOver();
}

void JointFeedback::handOver() {
  map_.fromWire(merger_.readings().angles_rad, readings_.angles_rad);
  readings_.counts = merger_.readings().counts;
  readings_.contested_joint = merger_.readings().contested_joint;
  executor_.feedback(readings_);
  ranges_.add(readings_);
  const std::lock_guard<std::mutex> lock(mutex_);
  rivals_ = merger_.rivals(readings_.contested_joint);
}

}  // namespace hexapod
