#pragma once

#include <ros/message_event.h>
#include <ros/node_handle.h>

#include <string>

#include "execution/shared_executor.h"
#include "hexapod_repertoire/ExecuteBehaviorAction.h"
#include "ros_interface/common/first_publisher.h"
#include "ros_interface/common/master_watch.h"
#include "ros_interface/common/realtime_loop.h"
#include "ros_interface/common/steady_action_server.h"
#include "ros_interface/executor/behavior_goals.h"
#include "ros_interface/executor/joint_feedback.h"
#include "ros_interface/executor/playable_behaviors.h"

namespace hexapod {

/// The action `execute` (BehaviorGoals) and the topic `repertoire` it plays from: of several nodes
/// that publish one, from the first one's. Used by the thread of the global callback queue, which
/// also calls poll().
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

  /// As in BehaviorGoals.
  /// @{
  void poll(const ExecutorStatus& status) { goals_.poll(status); }
  void abort(const std::string& why) { goals_.abort(why); }
  /// @}

 private:
  using Server = SteadyActionServer<hexapod_repertoire::ExecuteBehaviorAction>;

  void onRepertoire(const ros::MessageEvent<hexapod_repertoire::Repertoire const>& event);

  PlayableBehaviors behaviors_;
  FirstPublisher publisher_;
  BehaviorGoals goals_;
  Server server_;
  ros::Subscriber repertoire_subscriber_;
};

}  // namespace hexapod
