#include "ros_interface/executor/executor_reports.h"

#include <ros/console.h>

#include <cstring>

#include "hexapod_repertoire/ExecutorState.h"

namespace hexapod {
namespace {

constexpr double kStatePeriod_s = 1.0;
constexpr double kListenerPatience_s = 2.0;
constexpr double kListenerWarnPeriod_s = 10.0;
constexpr double kClockWarnPeriod_s = 2.0;

double steadyNow_s() { return 1e-9 * static_cast<double>(steadyNow_ns()); }

std::string topicsWithoutListener(const CommandSender& sender) {
  std::string topics;
  for (const ros::Publisher& publisher : sender.publishers()) {
    if (publisher.getNumSubscribers() > 0) continue;
    topics += (topics.empty() ? "" : ", ") + publisher.getTopic();
  }
  return topics;
}

std::string otherCommanders(const CommandSender& sender, const MasterWatch& master) {
  std::string others;
  for (const ros::Publisher& publisher : sender.publishers()) {
    for (const std::string& node : master.otherPublishers(publisher.getTopic())) {
      others += (others.empty() ? "" : ", ") + node + " on " + publisher.getTopic();
    }
  }
  return others;
}

}  // namespace

ExecutorReports::ExecutorReports(const ros::NodeHandle& private_node, const Sources& sources,
                                 const RobotDescription& robot)
    : sources_(sources),
      joint_names_(robot.jointNames()),
      body_(robot, sources.executor, sources.belief),
      start_s_(steadyNow_s()),
      next_listener_warning_s_(start_s_ + kListenerPatience_s),
      next_clock_warning_s_(start_s_ + kClockWarnPeriod_s) {
  ros::NodeHandle node(private_node);
  state_publisher_ = node.advertise<hexapod_repertoire::ExecutorState>("state", 1, true);
  updater_.setHardwareID("hexapod");
  updater_.add("state", this, &ExecutorReports::reportState);
  updater_.add("commands", this, &ExecutorReports::reportCommands);
  updater_.add("feedback", this, &ExecutorReports::reportFeedback);
  updater_.add("belief", &body_, &BodyReport::report);
  updater_.add("e_stop", this, &ExecutorReports::reportEStop);
}

void ExecutorReports::poll(const ExecutorStatus& status) {
  const ExecutorStatus before = status_;
  status_ = status;
  const double now_s = steadyNow_s();
  const bool body_changed = body_.poll(status);
  const bool changed = body_changed || status.mode != before.mode ||
                       status.cause.reason != before.cause.reason ||
                       status.entry_id != before.entry_id;
  if (changed) logChange(before);
  if (changed || now_s >= next_state_s_) {
    publishState();
    updater_.force_update();  // its own timer is ROS time, which may be set or stand still
    next_state_s_ = now_s + kStatePeriod_s;
  }
  watchCommandTopics(now_s);
  watchFeedback();
  watchClock(now_s);
  watchPriority();
}

void ExecutorReports::publishState() {
  hexapod_repertoire::ExecutorState message;
  message.header.stamp = ros::Time::now();
  message.state = static_cast<std::uint8_t>(status_.mode);
  message.reason = sources_.services.explain(status_.cause);
  message.entry_id = status_.entry_id;
  message.commands = status_.commands;
  message.skipped = status_.skipped;
  message.tolerated_joints = body_.tolerated();
  message.doubted_joints = body_.doubted();
  state_publisher_.publish(message);
}

void ExecutorReports::logChange(const ExecutorStatus& before) {
  if (status_.mode == before.mode) return;
  const std::string text =
      std::string(toString(status_.mode)) + ": " + sentence(status_.cause, joint_names_);
  if (status_.mode == ExecutorMode::kFault) {
    ROS_ERROR_STREAM(text);
  } else if (status_.mode == ExecutorMode::kStopped) {
    ROS_WARN_STREAM(text);
  } else if (status_.mode == ExecutorMode::kWalking || before.mode == ExecutorMode::kWalking) {
    ROS_DEBUG_STREAM(text);
  } else {
    ROS_INFO_STREAM(text);
  }
}

void ExecutorReports::watchCommandTopics(double now_s) {
  const std::string foreign = otherCommanders(sources_.sender, sources_.master);
  if (foreign != foreign_ && !foreign.empty()) {
    ROS_ERROR_STREAM("Somebody else commands the joints: "
                     << foreign << ". Stop it; the robot cannot obey two.");
  }
  foreign_ = foreign;
  if (now_s < next_listener_warning_s_) return;
  next_listener_warning_s_ = now_s + kListenerWarnPeriod_s;
  const std::string unheard = topicsWithoutListener(sources_.sender);
  if (unheard.empty()) return;
  ROS_WARN_STREAM("Nobody listens to " << unheard << " (" << sources_.sender.messageType()
                                       << "); start the robot's driver, or choose another "
                                          "~command_interface.");
}

void ExecutorReports::watchFeedback() {
  const std::string rivals = sources_.feedback.rivals();
  if (rivals != rivals_ && !rivals.empty()) {
    ROS_ERROR_STREAM("More than one node tells the angles of the same joints on "
                     << sources_.feedback.topic() << ": " << rivals
                     << ". The first is believed; stop the other, the executor cannot be armed "
                        "while both talk.");
  }
  rivals_ = rivals;
}

void ExecutorReports::watchPriority() {
  const int refusal = sources_.loop.realtimeRefusal();
  if (priority_told_ || refusal < 0) return;
  priority_told_ = true;
  if (refusal == 0) return;
  ROS_WARN_STREAM("No real-time priority ("
                  << std::strerror(refusal)
                  << "), so other programs may make commands late. Allow it (rtprio and memlock in "
                     "/etc/security/limits.conf), or set ~realtime to false.");
}

void ExecutorReports::watchClock(double now_s) {
  if (!sources_.loop.waitsForClock() || now_s < next_clock_warning_s_) return;
  next_clock_warning_s_ = now_s + kClockWarnPeriod_s;
  ROS_WARN(
      "/use_sim_time is true but no time comes on /clock; start what publishes /clock, or set "
      "/use_sim_time to false.");
}

void ExecutorReports::reportState(Diagnostics& diagnostics) {
  const bool bad = status_.mode == ExecutorMode::kFault || status_.mode == ExecutorMode::kStopped;
  diagnostics.summary(
      bad ? diagnostic_msgs::DiagnosticStatus::ERROR : diagnostic_msgs::DiagnosticStatus::OK,
      std::string(toString(status_.mode)) + ": " + sentence(status_.cause, joint_names_));
  const LoopTiming timing = sources_.loop.timing();
  diagnostics.add("Ticks", timing.ticks);
  diagnostics.add("Ticks skipped", timing.skipped);
  diagnostics.add("Mean lateness [ms]", 1e3 * timing.mean_lateness_s);
  diagnostics.add("Largest lateness [ms]", 1e3 * timing.largest_lateness_s);
  diagnostics.add("Real-time priority", sources_.loop.realtimeRefusal() == 0);
  if (sources_.loop.waitsForClock()) {
    diagnostics.mergeSummary(diagnostic_msgs::DiagnosticStatus::WARN, "Waiting for /clock.");
  }
}

void ExecutorReports::reportCommands(Diagnostics& diagnostics) {
  const std::string unheard = topicsWithoutListener(sources_.sender);
  diagnostics.summary(diagnostic_msgs::DiagnosticStatus::OK, "Command topics are in order.");
  if (!foreign_.empty()) {
    diagnostics.summary(diagnostic_msgs::DiagnosticStatus::ERROR,
                        "Somebody else commands the joints: " + foreign_);
  } else if (!unheard.empty()) {
    diagnostics.summary(diagnostic_msgs::DiagnosticStatus::WARN, "Nobody listens to " + unheard);
  }
  diagnostics.add("Commands sent", status_.commands);
  diagnostics.add("Commands skipped", status_.skipped);
  diagnostics.add("Commands held back by limits", status_.clamped);
}

void ExecutorReports::reportFeedback(Diagnostics& diagnostics) {
  const bool bad = status_.cause.reason == Reason::kFeedbackLost ||
                   status_.cause.reason == Reason::kFeedbackFrozen;
  const std::string topic = sources_.feedback.topic();
  const std::string good =
      topic.empty() ? "Open loop: joint states are not looked at." : "Joint states on " + topic;
  diagnostics.summary(
      bad ? diagnostic_msgs::DiagnosticStatus::ERROR : diagnostic_msgs::DiagnosticStatus::OK,
      bad ? sentence(status_.cause, joint_names_) : good);
  if (!rivals_.empty()) {
    diagnostics.summary(diagnostic_msgs::DiagnosticStatus::ERROR,
                        "More than one node tells the same joints' angles: " + rivals_);
  }
  diagnostics.add("Messages used", sources_.feedback.received());
  diagnostics.add("Messages refused", sources_.feedback.refused());
  diagnostics.add("Last refused because", sources_.feedback.problem());
}

void ExecutorReports::reportEStop(Diagnostics& diagnostics) {
  const std::uint32_t publishers = sources_.emergency_stop.publishers();
  const bool gone = had_e_stop_ && publishers == 0;
  had_e_stop_ = had_e_stop_ || publishers > 0;
  diagnostics.summary(
      gone ? diagnostic_msgs::DiagnosticStatus::WARN : diagnostic_msgs::DiagnosticStatus::OK,
      gone ? "The publisher of e_stop is gone; only ~stop stops the robot now."
           : (publishers > 0 ? "Somebody publishes e_stop." : "Nobody publishes e_stop."));
}

}  // namespace hexapod
