#pragma once

#include <ros/message_event.h>
#include <ros/node_handle.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "execution/shared_executor.h"
#include "hexapod_repertoire/ExecuteBehaviorAction.h"
#include "ros_interface/common/first_publisher.h"
#include "ros_interface/common/master_watch.h"
#include "ros_interface/common/realtime_loop.h"
#include "ros_interface/common/steady_action_server.h"
#include "ros_interface/executor/joint_feedback.h"
#include "ros_interface/executor/playable_behaviors.h"

namespace hexapod {

/// The action `execute` and the topic `repertoire` it plays from: of several nodes that publish
/// one, from the first one's.
///
/// One behaviour at a time: a goal that comes while one is played is rejected, not queued, and does
/// not disturb it. Used by the thread of the global callback queue, which also calls poll().
class ExecuteAction {
 public:
  /// What it works with; must outlive it.
  struct Means {
    SharedExecutor& executor;
    const RealtimeLoop& loop;
    JointFeedback& feedback;
    const MasterWatch& master;  ///< of the topic `repertoire` among others
    const RobotDescription& robot;
  };

  ExecuteAction(ros::NodeHandle& node, const Means& means, const BehaviorOptions& options);

  /// Ends the goal when its behaviour has ended, and publishes feedback now and then.
  void poll(const ExecutorStatus& status);

  /// Aborts the goal under way; for a node that leaves.
  void abort(const std::string& why);

  std::size_t entryCount() const { return behaviors_.entryCount(); }

 private:
  using Server = SteadyActionServer<hexapod_repertoire::ExecuteBehaviorAction>;
  using Goal = Server::GoalHandle;
  using Result = hexapod_repertoire::ExecuteBehaviorResult;

  void onRepertoire(const ros::MessageEvent<hexapod_repertoire::Repertoire const>& event);
  void onGoal(Goal goal);
  void onCancel(const Goal& goal);
  void reject(Goal& goal, std::uint8_t code, const std::string& message);
  void finish(const BehaviorEnd& end);

  Means means_;
  PlayableBehaviors behaviors_;
  FirstPublisher publisher_;
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
