#pragma once

#include <ros/time.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "execution/shared_executor.h"
#include "hexapod_repertoire/ExecuteBehaviorFeedback.h"
#include "hexapod_repertoire/ExecuteBehaviorGoal.h"
#include "hexapod_repertoire/ExecuteBehaviorResult.h"
#include "ros_interface/executor/joint_ranges.h"
#include "ros_interface/executor/playable_behaviors.h"

namespace hexapod {

/// Who sent a goal, as far as it is told of it.
class GoalSender {
 public:
  using Result = hexapod_repertoire::ExecuteBehaviorResult;

  virtual ~GoalSender() = default;
  /// Played from now on.
  virtual void accepted() = 0;
  virtual void feedback(const hexapod_repertoire::ExecuteBehaviorFeedback& feedback) = 0;
  /// The answer to a goal that was accepted; nothing follows.
  virtual void ended(const Result& result) = 0;
  /// The answer to a goal that is not played; nothing follows.
  virtual void refused(const Result& result) = 0;
};

/// The goals of `execute`, without the wire: every one is answered exactly once.
///
/// One behaviour at a time: a goal that comes while one is played is refused, not queued, and does
/// not disturb it. Used by one thread.
class BehaviorGoals {
 public:
  /// What it works with; must outlive it.
  struct Means {
    SharedExecutor& executor;
    PlayableBehaviors& behaviors;
    JointRanges* ranges = nullptr;                      ///< nullptr: joints are not read
    std::function<ros::Time(std::int64_t slot)> stamp;  ///< of a command period
    std::vector<std::string> joint_names;
    double command_period_s = 0.0;
  };

  explicit BehaviorGoals(Means means) : means_(std::move(means)) {}

  /// A goal, under an id that no other has.
  void take(const std::string& id, const hexapod_repertoire::ExecuteBehaviorGoal& goal,
            std::unique_ptr<GoalSender> sender);

  /// Breaks the behaviour of this goal off; nothing where it is not played (any more).
  void cancel(const std::string& id);

  /// Answers the goal when its behaviour has ended, and tells how far it is now and then.
  void poll(const ExecutorStatus& status);

  /// Answers the goal under way; for a node that leaves.
  void abort(const std::string& why);

 private:
  using Result = GoalSender::Result;

  static void refuse(GoalSender& sender, std::uint8_t code, const std::string& message);
  void end(const Result& result);
  void finish(const BehaviorEnd& end);

  Means means_;
  std::unique_ptr<GoalSender> sender_;  // of the goal that is played; nullptr: none is
  std::string id_;
  std::uint64_t serial_ = 0;  // of the behaviour played for it
  std::shared_ptr<const Behavior> behavior_;
  double next_feedback_s_ = 0.0;
};

}  // namespace hexapod
