#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>

#include "ros_interface/planner/walk_goal.h"

namespace hexapod {

/// One goal from its arrival to its answer. Sees to it that its listener hears exactly one end, and
/// nothing after it, whoever ends it: the walk, a cancel, a newer goal, the node that leaves.
/// From any thread.
class OpenGoal {
 public:
  /// `stops`: BehaviorPlayer::stops() on arrival.
  OpenGoal(std::uint64_t number, std::string id, GoalRequest request, GoalListener listener,
           std::uint64_t stops);

  const std::uint64_t number;  ///< in order of arrival
  const std::string id;
  const GoalRequest request;
  const std::uint64_t stops;

  /// Set while the walk's thread thinks: it looks at nothing else meanwhile.
  std::atomic<bool> is_thought_about{false};

  /// Soon true after somebody ended it: nothing more is to be done for it.
  bool ended() const { return ended_; }

  /// Asks `may_begin`; if it says yes, tells the listener and is accepted. `may_begin` may not end
  /// goals.
  bool accept(const WalkReport& report, const WalkGoal& goal,
              const std::function<bool()>& may_begin);

  /// In the global frame; of an accepted goal.
  const WalkGoal& goal() const { return goal_; }

  /// How far the walk is: what a client hears of it when somebody else ends the goal.
  void note(const WalkReport& so_far);
  void tellProgress(const WalkProgress& progress);

  /// The answer; false when it had one already.
  bool end(const WalkReport& report);
  /// The answer, with what was noted of the walk so far.
  bool end(std::uint8_t code, const std::string& message);

  /// What it ended with, or how far it is.
  WalkReport report() const;

 private:
  const GoalListener listener_;
  std::atomic<bool> ended_{false};
  mutable std::mutex mutex_;  // held while the listener is called
  WalkReport so_far_;         // guarded by mutex_
  WalkGoal goal_;             // written before acceptance
};

}  // namespace hexapod
