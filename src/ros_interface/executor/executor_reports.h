#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <cstdint>
#include <string>
#include <vector>

#include "execution/executor_status.h"
#include "ros_interface/common/master_watch.h"
#include "ros_interface/common/realtime_loop.h"
#include "ros_interface/executor/belief_listener.h"
#include "ros_interface/executor/body_report.h"
#include "ros_interface/executor/command_sender.h"
#include "ros_interface/executor/emergency_stop.h"
#include "ros_interface/executor/executor_services.h"
#include "ros_interface/executor/joint_feedback.h"

namespace hexapod {

/// Tells people how the executor is: the latched topic ~state, diagnostics, and log sentences about
/// changes, joints that are believed dead or in doubt, a command topic nobody listens to or
/// somebody else publishes on, feedback from two nodes at once, a clock that does not come, a
/// real-time priority that is refused. Used by one thread.
class ExecutorReports {
 public:
  struct Sources {
    const SharedExecutor& executor;
    const CommandSender& sender;
    const JointFeedback& feedback;
    const BeliefListener& belief;
    const ExecutorServices& services;
    const EmergencyStop& emergency_stop;
    const MasterWatch& master;
    const RealtimeLoop& loop;
  };

  /// The sources must outlive it.
  ExecutorReports(const ros::NodeHandle& private_node, const Sources& sources,
                  const RobotDescription& robot);

  void poll(const ExecutorStatus& status);

 private:
  using Diagnostics = diagnostic_updater::DiagnosticStatusWrapper;

  void publishState();
  void logChange(const ExecutorStatus& before);
  void watchCommandTopics(double now_s);
  void watchFeedback();
  void watchClock(double now_s);
  void watchPriority();
  void reportState(Diagnostics& diagnostics);
  void reportCommands(Diagnostics& diagnostics);
  void reportFeedback(Diagnostics& diagnostics);
  void reportEStop(Diagnostics& diagnostics);

  Sources sources_;
  std::vector<std::string> joint_names_;
  BodyReport body_;
  ros::Publisher state_publisher_;
  diagnostic_updater::Updater updater_;
  ExecutorStatus status_;
  double start_s_;
  double next_state_s_ = 0.0;
  double next_listener_warning_s_;
  double next_clock_warning_s_;
  std::string foreign_;
  std::string rivals_;
  bool priority_told_ = false;
  bool had_e_stop_ = false;
};

}  // namespace hexapod
