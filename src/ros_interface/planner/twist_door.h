#pragma once

#include <geometry_msgs/Twist.h>
#include <ros/callback_queue_interface.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include <cstdint>
#include <mutex>
#include <optional>

#include "ros_interface/common/clock.h"
#include "ros_interface/planner/walker.h"

namespace hexapod {

/// The topic cmd_vel: a goal for the walker as long as velocities keep coming. The first one of a
/// stream takes over from other goals. A stream that was refused, cancelled or overtaken walks no
/// more, not even when somebody arms: a new one begins after a zero velocity or a silence.
class TwistDoor {
 public:
  /// The stream ends `timeout_s` after its last message. All references must outlive it.
  TwistDoor(const ros::NodeHandle& node, ros::CallbackQueueInterface& queue, const Clock& clock,
            Walker& walker, double timeout_s);

 private:
  void receive(const geometry_msgs::Twist::ConstPtr& message);
  std::optional<Twist> present() const;
  /// Keeps the velocity. True when a goal is to be submitted for it.
  bool begins(const std::optional<Twist>& twist);
  void onEnd(const WalkReport& report);

  const Clock& clock_;
  Walker& walker_;
  std::int64_t timeout_ns_;
  mutable std::mutex mutex_;
  std::optional<Twist> twist_;    // guarded by mutex_; nothing: stand
  std::int64_t received_ns_ = 0;  // guarded by mutex_; steady
  bool is_open_ = false;          // guarded by mutex_; the walker has a goal of ours
  bool is_barred_ = false;        // guarded by mutex_; until the stream ends
  ros::Subscriber subscriber_;
};

}  // namespace hexapod
