#pragma once

#include <actionlib/server/action_server.h>
#include <ros/node_handle.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "execution/shared_executor.h"
#include "hexapod_repertoire/ExecuteBehaviorAction.h"
#include "ros_interface/common/realtime_loop.h"
#include "ros_interface/executor/playable_behaviors.h"

namespace hexapod {

/// The action `execute` and the topic `repertoire` it plays from.
///
/// One behaviour at a time: a goal that comes while one is played is rejected, not queued, and does
/// not disturb it. Used by the thread of the global callback queue, which also calls poll().
class ExecuteAction {
 public:
  /// The references must outlive it.
  ExecuteAction(ros::NodeHandle& node, SharedExecutor& executor, const RealtimeLoop& loop,
                const RobotDescription& robot, const BehaviorOptions& options);

  /// Ends the goal when its behaviour has ended, and publishes feedback now and then.
  void poll(const ExecutorStatus& status);

  /// Aborts the goal under way; for a node that leaves.
  void abort(const std::string& why);

  std::size_t entryCount() const { return behaviors_.entryCount(); }

 private:
  using Server = actionlib::ActionServer<hexapod_repertoire::ExecuteBehaviorAction>;
  using Goal = Server::GoalHandle;
  using Result = hexapod_repertoire::ExecuteBehaviorResult;

  void onRepertoire(const hexapod_repertoire::Repertoire::ConstPtr& message);
  void onGoal(Goal goal);
  void onCancel(Goal goal);
  void reject(Goal& goal, std::uint8_t code, const std::string& message);
  void finish(const BehaviorEnd& end);

  SharedExecutor& executor_;
  const RealtimeLoop& loop_;
  PlayableBehaviors behaviors_;
  std::vector<std::string> joint_names_;
  double period_s_;
  Goal goal_;
  bool playing_ = false;
  std::uint64_t serial_ = 0;  // of the behaviour played for goal_
  std::shared_ptr<const Behavior> behavior_;
  double next_feedback_s_ = 0.0;
  Server server_;
  ros::Subscriber repertoire_subscriber_;
};

}  // namespace hexapod
