#pragma once

#include <ros/node_handle.h>

#include <memory>

#include "execution/shared_executor.h"
#include "robot/robot_description.h"
#include "ros_interface/common/master_watch.h"
#include "ros_interface/common/realtime_loop.h"
#include "ros_interface/executor/belief_listener.h"
#include "ros_interface/executor/command_sender.h"
#include "ros_interface/executor/emergency_stop.h"
#include "ros_interface/executor/execute_action.h"
#include "ros_interface/executor/executor_node_options.h"
#include "ros_interface/executor/executor_reports.h"
#include "ros_interface/executor/executor_services.h"
#include "ros_interface/executor/joint_feedback.h"
#include "ros_interface/executor/sending_thread.h"

namespace hexapod {

/// The executor on ROS: command loop, sending, emergency stop, feedback, services, action, reports.
/// All have threads of their own but the action and the reports, which share run()'s.
class ExecutorNode {
 public:
  /// Why run() came back.
  enum class End { kAskedToLeave, kMasterLost };

  /// Throws std::invalid_argument when options, joint map and robot do not fit together.
  ExecutorNode(ros::NodeHandle& node, const ros::NodeHandle& private_node,
               const ExecutorNodeOptions& options, const RobotDescription& robot);

  /// Serves callbacks until `leave` is set, ROS shuts down, or the master is lost and no behaviour
  /// is being played. Nothing is sent any more when it returns.
  End run(const std::atomic<bool>& leave);

 private:
  RealtimeLoop::Callbacks loopCallbacks();
  void autoArm();
  void breakOffAfterReset();

  SystemClock clock_;
  RobotDescription robot_;
  JointMap map_;
  bool auto_arm_;
  std::int64_t next_auto_arm_ns_ = 0;
  SharedExecutor executor_;
  std::unique_ptr<CommandSender> sender_;
  SendingThread sending_;
  RealtimeLoop loop_;
  EmergencyStop emergency_stop_;
  JointFeedback feedback_;
  BeliefListener belief_;
  ExecutorServices services_;
  MasterWatch master_;
  ExecuteAction action_;
  ExecutorReports reports_;
};

}  // namespace hexapod
