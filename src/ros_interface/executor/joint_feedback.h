#pragma once

#include <ros/callback_queue.h>
#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/Header.h>

#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "execution/feedback_merger.h"
#include "execution/joint_map.h"
#include "execution/shared_executor.h"
#include "ros_interface/common/clock.h"
#include "ros_interface/executor/joint_ranges.h"

namespace hexapod {

/// Takes joint_states, from one driver or from several for some joints each, and hands what is
/// believed of it (FeedbackMerger) to the executor. Hears of resets on robot_reset, whose stamps
/// are judged as those of joint_states. On a queue and a thread of its own, with `realtime` of a
/// real-time priority: neither another callback nor another program makes feedback old. Public
/// functions from any thread.
class JointFeedback {
 public:
  /// `executor` and `clock` must outlive it. `timeout_s` 0: joint_states are not listened to, open
  /// loop.
  JointFeedback(const ros::NodeHandle& node, SharedExecutor& executor, const JointMap& map,
                double timeout_s, const Clock& clock, bool realtime);

  std::uint64_t received() const { return received_; }
  std::uint64_t refused() const { return refused_; }
  /// Sentence about the last message refused; empty when none was.
  std::string problem() const;
  /// The nodes that contest a joint, as "/a and /b"; empty while none is contested.
  std::string rivals() const;
  /// Empty: open loop.
  std::string topic() const { return subscriber_.getTopic(); }
  /// When the robot was put elsewhere, on Clock::robotNow_ns(); nothing when that was taken before.
  std::optional<std::int64_t> takeReset();
  /// How far the joints move.
  JointRanges& ranges() { return ranges_; }

 private:
  using Event = ros::MessageEvent<const sensor_msgs::JointState>;

  void onJointState(const Event& event);
  void onReset(const ros::MessageEvent<const std_msgs::Header>& event);
  void handOver();

  SharedExecutor& executor_;
  JointMap map_;
  const Clock& clock_;
  const bool realtime_;
  FeedbackMerger merger_;   // feedback thread
  JointReadings readings_;  // feedback thread; as the robot description counts angles
  JointRanges ranges_;
  std::atomic<std::uint64_t> received_{0};
  std::atomic<std::uint64_t> refused_{0};
  mutable std::mutex mutex_;
  std::string problem_;                   // guarded by mutex_
  std::string rivals_;                    // guarded by mutex_
  std::optional<std::int64_t> reset_ns_;  // guarded by mutex_
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::Subscriber subscriber_;
  ros::Subscriber reset_subscriber_;
  ros::AsyncSpinner spinner_;
};

}  // namespace hexapod
