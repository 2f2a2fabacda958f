#pragma once

#include <ros/node_handle.h>

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "repertoire/entry.h"
#include "ros_interface/common/clock.h"
#include "ros_interface/robot_client/measured_behavior.h"

namespace hexapod {

/// Has the robot play entries, one at a time, and tells what became of each. Waits in a thread of
/// its own; the functions may be called from any.
class RobotPlayer {
 public:
  /// What became of an order.
  struct Report : MeasuredBehavior {
    Entry entry;
  };
  using Tell = std::function<void(const Report&)>;

  /// `tell` is called when an order begins (without `reached` and `problem`) and when it ends, from
  /// the player's thread. All must outlive it. `settle`: for the robot to come to rest.
  RobotPlayer(BehaviorPlayer& executor, const PoseSource& poses, const ros::Duration& settle,
              Tell tell);
  ~RobotPlayer();
  RobotPlayer(const RobotPlayer&) = delete;
  RobotPlayer& operator=(const RobotPlayer&) = delete;

  /// Begins to play an entry, or returns a sentence why not: the executor is not ready for it, or
  /// plays one already.
  std::string play(const std::string& run_id, const Entry& entry);

  bool isPlaying() const;

 private:
  struct Order {
    std::string run_id;
    Entry entry;
    std::uint64_t stops;
  };

  void work();
  void play(const Order& order);
  bool leaves() const;

  BehaviorPlayer& executor_;
  const PoseSource& poses_;
  const ros::Duration settle_;
  const Tell tell_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Order> order_;  // guarded by mutex_, as the next; until it has been played
  bool leaves_ = false;
  std::thread thread_;
};

}  // namespace hexapod
