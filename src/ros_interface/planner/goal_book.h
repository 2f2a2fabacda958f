#pragma once

#include <condition_variable>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "ros_interface/planner/open_goal.h"

namespace hexapod {

/// The goals that have come and have not been answered yet, and which of them is next.
///
/// Goals are numbered on arrival. Accepting one ends all older ones but the one being walked, which
/// ends at its next rest; an older one that is examined later, however long that took, is too late.
/// After close() every goal is answered, those that still come too. Knows no ROS and starts no
/// threads; from any thread.
class GoalBook {
 public:
  using Goal = std::shared_ptr<OpenGoal>;

  /// Enters a goal; with an empty id it gets one. `stops` as in OpenGoal; one with an `answer` ends
  /// with it at once.
  Goal enter(std::string id, const GoalRequest& request, const GoalListener& listener,
             std::uint64_t stops, std::optional<WalkReport> answer = std::nullopt);

  /// The newest goal that nobody has examined; waits for one. Null once closed.
  Goal takeToExamine();

  /// Examined and good: it will be walked to, older ones end. False when it is ended itself.
  bool accept(const Goal& goal, const WalkReport& report, const WalkGoal& target);

  /// The goal to walk to; waits for one. Null once closed.
  Goal takeToWalk();

  /// The goal that is being walked to; null while none is.
  Goal walked() const;

  /// Another goal is to be walked to.
  bool newerIsNext() const;

  /// Of a goal that has ended: nobody works on it any more.
  void strike(const Goal& goal);

  /// Ends the goals as PREEMPTED: all of them, or the one of this id. How many those were.
  std::size_t cancelAll();
  std::size_t cancel(const std::string& id);

  /// Ends all goals, and from now on every one that comes.
  void close(std::uint8_t code, const std::string& message);
  bool isClosed() const;

  /// Goals not answered yet.
  std::size_t open() const;

 private:
  std::size_t cancelWhere(const std::string& id);

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t numbers_ = 0;  // guarded by mutex_, as all that follow
  std::uint64_t newest_accepted_ = 0;
  std::list<Goal> goals_;       // not struck; oldest first
  std::list<Goal> unexamined_;  // oldest first
  Goal next_;                   // accepted, not begun
  Goal walked_;
  bool closed_ = false;
  WalkReport closing_;
};

}  // namespace hexapod
