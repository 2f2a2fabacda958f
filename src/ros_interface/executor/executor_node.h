#pragma once

#include <ros/node_handle.h>
#include <std_msgs/Header.h>

#include <memory>

#include "execution/shared_executor.h"
#include "robot/robot_description.h"
#include "ros_interface/common/master_watch.h"
#include "ros_interface/common/realtime_loop.h"
#include "ros_interface/executor/command_sender.h"
#include "ros_interface/executor/execute_action.h"
#include "ros_interface/executor/executor_node_options.h"
#include "ros_interface/executor/executor_reports.h"
#include "ros_interface/executor/executor_services.h"
#include "ros_interface/executor/joint_feedback.h"

namespace hexapod {

/// The executor on ROS: command loop, action, services, reports. The command loop has its own
/// thread; run() and the action, the feedback and the reports share the caller's.
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
  void onReset(const std_msgs::Header::ConstPtr& message);

  RobotDescription robot_;
  JointMap map_;
  bool auto_arm_;
  std::int64_t next_auto_arm_ns_ = 0;
  SharedExecutor executor_;
  std::unique_ptr<CommandSender> sender_;
  ros::Time tick_stamp_;  // loop thread
  SharedExecutor::Send send_;
  RealtimeLoop loop_;
  ExecuteAction action_;
  ExecutorServices services_;
  JointFeedback feedback_;
  MasterWatch master_;
  ExecutorReports reports_;
  ros::Subscriber reset_subscriber_;
};

}  // namespace hexapod
