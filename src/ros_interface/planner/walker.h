#pragma once

#include <string>
#include <thread>
#include <vector>

#include "ros_interface/common/cancel_memory.h"
#include "ros_interface/planner/goal_book.h"
#include "ros_interface/planner/goal_examiner.h"
#include "ros_interface/planner/walk_run.h"

namespace hexapod {

/// Takes goals, examines them in two threads, walks to them in a third, one at a time. The newest
/// takes over when the behaviour under way has ended; a cancel breaks it off. Every goal is
/// answered exactly once. Public functions from any thread; all but the destructor return at once.
class Walker {
 public:
  /// All of it must outlive the walker.
  struct Means {
    const PlannerNodeOptions& options;
    const Clock& clock;
    const PoseSource& poses;
    const RepertoireInUse& repertoire;
    BehaviorPlayer& player;
    WalkWatcher& watcher;
    ObstacleSource obstacles = {};          ///< may be empty
    ObstacleProblem obstacle_problem = {};  ///< may be empty
  };

  explicit Walker(const Means& means);
  /// Closes, and waits until the behaviour under way is broken off.
  ~Walker();

  /// Enters a goal; returns its id, a new one for an empty one.
  std::string submit(const GoalRequest& request, const GoalListener& listener,
                     const std::string& id = "");

  /// False when there was nothing to cancel. A goal that was sent before and comes after is
  /// cancelled, too (CancelMemory).
  bool cancelAll();
  bool cancel(const std::string& id) { return book_.cancel(id) > 0; }

  /// To be called often: tells at once that the executor cannot go on while a walk thinks about its
  /// next behaviour, which may take its time.
  void look();

  /// Answers every goal with this code and sentence, those that still come too, and walks no more.
  void close(std::uint8_t code, const std::string& message) { book_.close(code, message); }
  bool isClosed() const { return book_.isClosed(); }

  const GoalExaminer& examiner() const { return examiner_; }

 private:
  void examineGoals();
  void examine(const GoalBook::Goal& goal);
  void walkToGoals();
  WalkReport walkTo(OpenGoal& goal);
  void showIfRefused(const WalkGoal& goal, const WalkReport& report);

  Means means_;
  GoalExaminer examiner_;
  GoalBook book_;
  CancelMemory cancels_;
  std::vector<std::thread> threads_;
};

}  // namespace hexapod
