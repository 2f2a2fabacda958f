#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "hexapod_repertoire/Repertoire.h"
#include "planning/walk.h"
#include "ros_interface/display/walk_display.h"
#include "ros_interface/planner/behavior_client.h"
#include "ros_interface/planner/planner_node_options.h"
#include "ros_interface/planner/pose_source.h"
#include "ros_interface/planner/walk_goal.h"

namespace hexapod {

/// Walks to goals, one at a time, in a thread of its own: measure, plan, have one behaviour
/// executed, report, again. The newest goal takes over when the behaviour under way has ended.
/// Public functions from any thread.
class Walker {
 public:
  Walker(ros::NodeHandle& node, ros::NodeHandle& private_node, const PlannerNodeOptions& options);
  ~Walker();

  const PoseSource& poses() const { return poses_; }

  /// The answer to "could you?": checks and plans from where the robot stands, moves nothing. Code
  /// SUCCEEDED means there is a plan. Publishes nothing.
  WalkReport makePlan(const Pose2& goal, const GoalTolerance& tolerance) const;
  WalkReport makePlan(const Pose2& start, const Pose2& goal, const GoalTolerance& tolerance) const;

  /// Takes over the goal; returns its id. Earlier goals end as PREEMPTED.
  std::string submit(WalkGoal goal);

  /// Breaks off what is under way. False when there was nothing.
  bool cancel();

  /// Cancels only the goal of this id.
  bool cancel(const std::string& goal_id);

  /// Whether a repertoire has arrived, and how many entries may be planned with.
  std::optional<std::size_t> usableEntries() const;

 private:
  void receive(const hexapod_repertoire::Repertoire::ConstPtr& message);
  std::shared_ptr<AdaptivePlanner> planner() const;
  void work();
  void walk(const WalkGoal& goal);
  WalkReport walkTo(const WalkGoal& goal);
  bool interrupted() const { return cancel_ || shutdown_; }
  std::string reasonToEnd() const;

  PlannerNodeOptions options_;
  PoseSource poses_;
  BehaviorClient executor_;
  WalkDisplay display_;
  ros::Subscriber repertoire_subscriber_;

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::shared_ptr<AdaptivePlanner> planner_;  // guarded by mutex_; one per repertoire
  std::optional<WalkGoal> pending_;           // guarded by mutex_
  std::string active_id_;                     // guarded by mutex_; empty: idle
  std::uint64_t goals_ = 0;                   // guarded by mutex_
  std::atomic<bool> cancel_{false};
  std::atomic<bool> shutdown_{false};
  std::thread thread_;
};

}  // namespace hexapod
