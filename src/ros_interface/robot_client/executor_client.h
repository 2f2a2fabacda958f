#pragma once

#include <actionlib_msgs/GoalStatusArray.h>

#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "hexapod_repertoire/ExecuteBehaviorAction.h"
#include "hexapod_repertoire/ExecutorState.h"
#include "ros_interface/common/clock.h"
#include "ros_interface/robot_client/behavior_player.h"
#include "ros_interface/robot_client/silence.h"

namespace hexapod {

/// What the client of the executor needs of the wire.
class ExecutorWire {
 public:
  virtual ~ExecutorWire() = default;
  /// Somebody takes the goals.
  virtual bool isConnected() const = 0;
  virtual void send(const hexapod_repertoire::ExecuteBehaviorActionGoal& goal) = 0;
  virtual void cancel(const actionlib_msgs::GoalID& id) = 0;
};

/// The executor as a BehaviorPlayer: a client of its action `execute` and of `executor/state`.
///
/// Speaks actionlib's wire itself, because actionlib's client waits for ROS time to begin and
/// measures on it. Believes in an executor as long as anything comes from it; one that is silent
/// for 1.7 s is gone; whoever owns it asks whyNotReady() some times a second. The on...() functions
/// may be called from any thread, at any time.
class ExecutorClient : public BehaviorPlayer {
 public:
  /// `name`: of this node; goals are named after it. Both references must outlive it.
  ExecutorClient(const Clock& clock, ExecutorWire& wire, std::string name);

  std::string whyNotReady() const override;
  std::uint64_t stops() const override { return stops_; }
  Result awaitReady(std::uint64_t stops, const Interrupted& interrupted) override;
  Result play(const Order& order) override;

  void onState(const hexapod_repertoire::ExecutorState& state);
  void onStatus(const actionlib_msgs::GoalStatusArray& status);
  void onFeedback(const hexapod_repertoire::ExecuteBehaviorActionFeedback& feedback);
  void onResult(const hexapod_repertoire::ExecuteBehaviorActionResult& result);

 private:
  using Answer = hexapod_repertoire::ExecuteBehaviorActionResult;

  Result playOnce(const Order& order);
  Result awaitEnd(const actionlib_msgs::GoalID& id, const Interrupted& interrupted);
  Result breakOff(const actionlib_msgs::GoalID& id);
  std::optional<ros::Time> readySince() const;
  std::string whySilent() const;
  std::optional<Result> ended() const;

  const Clock& clock_;
  ExecutorWire& wire_;
  const std::string name_;
  std::uint64_t goals_ = 0;  // thread of play()
  std::atomic<std::uint64_t> stops_{0};
  std::atomic<std::uint64_t> signs_{0};  // of life of the behaviour under way

  mutable std::mutex mutex_;
  std::optional<hexapod_repertoire::ExecutorState> state_;  // guarded by mutex_
  ros::Time ready_;                                         // guarded by mutex_; since when
  mutable Silence silence_;                                 // guarded by mutex_; of the executor
  std::string goal_id_;                                     // guarded by mutex_; under way
  std::optional<Answer> answer_;                            // guarded by mutex_; to goal_id_
};

}  // namespace hexapod
