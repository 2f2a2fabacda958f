#include "ros_interface/executor/execute_action.h"

#include <ros/callback_queue.h>
#include <ros/console.h>

#include <exception>

#include "ros_interface/common/names.h"
#include "ros_interface/executor/behavior_result.h"

namespace hexapod {
namespace {

constexpr double kFeedbackPeriod_s = 0.2;

using Result = hexapod_repertoire::ExecuteBehaviorResult;

Result cancelledEarly() {
  Result result;
  result.code = Result::PREEMPTED;
  result.message = "Cancelled before it arrived.";
  return result;
}

}  // namespace

ExecuteAction::ExecuteAction(ros::NodeHandle& node, const Means& means,
                             const BehaviorOptions& options)
    : means_(means),
      behaviors_(means.robot, options),
      publisher_([&master = means.master, topic = node.resolveName(names::kRepertoire)] {
        return master.otherPublishers(topic);
      }),
      joint_names_(means.robot.jointNames()),
      period_s_(options.command_period_s),
      server_(
          node, names::kExecute, *ros::getGlobalCallbackQueue(),
          [this](const Goal& goal) { onGoal(goal); }, [this](const Goal& goal) { onCancel(goal); },
          cancelledEarly()) {
  repertoire_subscriber_ =
      node.subscribe(names::kRepertoire, 1, &ExecuteAction::onRepertoire, this);
  server_.start();
}

void ExecuteAction::onRepertoire(
    const ros::MessageEvent<hexapod_repertoire::Repertoire const>& event) {
  const auto& message = event.getConstMessage();
  std::string problem = publisher_.whyRefused(event.getPublisherName());
  if (problem.empty()) problem = behaviors_.update(*message);
  if (!problem.empty()) {
    ROS_ERROR_STREAM(problem);
    return;
  }
  publisher_.use(event.getPublisherName());
  ROS_INFO_STREAM("Playing from run '" << message->run_id << "', " << behaviors_.entryCount()
                                       << " entries.");
}

void ExecuteAction::onGoal(Goal goal) {
  // A burst of goals while one is played costs the command loop nothing.
  const ExecutorMode mode = means_.executor.status().mode;
  if (mode != ExecutorMode::kReady) {
    return reject(goal, Result::NOT_READY, sentence({Reason::kNotReady, mode}, joint_names_));
  }
  std::string problem;
  std::shared_ptr<const Behavior> behavior;
  try {
    behavior = behaviors_.find(*goal.getGoal(), problem);
  } catch (const std::exception& error) {
    problem = error.what();
  }
  if (!behavior) return reject(goal, Result::INVALID_GOAL, problem);
  const Cause cause = means_.executor.start(*behavior, goal.getGoal()->entry_id);
  if (!cause.accepted()) {
    return reject(goal, Result::NOT_READY, sentence(cause, joint_names_));
  }
  means_.feedback.ranges().begin();
  goal.setAccepted();
  goal_ = goal;
  playing_ = true;
  serial_ = means_.executor.status().serial;
  behavior_ = behavior;
  next_feedback_s_ = 0.0;
}

void ExecuteAction::onCancel(const Goal& goal) {
  if (!playing_ || !(goal == goal_)) return;
  // A behaviour that has just come to its end is not broken off any more; poll() tells.
  means_.executor.cancel(Reason::kCancelled);
}

void ExecuteAction::reject(Goal& goal, std::uint8_t code, const std::string& message) {
  Result result;
  result.code = code;
  result.message = message;
  ROS_WARN_STREAM("Goal refused: " << message);
  goal.setRejected(result, message);
}

void ExecuteAction::poll(const ExecutorStatus& status) {
  if (!playing_) return;
  if (status.last_end.serial >= serial_) return finish(status.last_end);
  const double elapsed_s = static_cast<double>(status.played) * period_s_;
  if (elapsed_s < next_feedback_s_) return;
  next_feedback_s_ = elapsed_s + kFeedbackPeriod_s;
  hexapod_repertoire::ExecuteBehaviorFeedback feedback;
  feedback.elapsed_s = static_cast<float>(elapsed_s);
  feedback.duration_s = static_cast<float>(behavior_->duration_s());
  goal_.publishFeedback(feedback);
}

void ExecuteAction::finish(const BehaviorEnd& end) {
  Result result = behaviorResult(end, behavior_->commandCount(), joint_names_);
  result.finished = means_.loop.stamp(end.last_slot);
  if (!means_.feedback.topic().empty()) {
    result.joint_min_rad = means_.feedback.ranges().min_rad();
    result.joint_max_rad = means_.feedback.ranges().max_rad();
  }
  playing_ = false;
  behavior_.reset();
  if (result.code == Result::SUCCEEDED) {
    goal_.setSucceeded(result, result.message);
  } else if (result.code == Result::PREEMPTED) {
    goal_.setCanceled(result, result.message);
  } else {
    goal_.setAborted(result, result.message);
  }
}

void ExecuteAction::abort(const std::string& why) {
  if (!playing_) return;
  Result result;
  result.code = Result::STOPPED;
  result.message = why;
  playing_ = false;
  goal_.setAborted(result, why);
}

}  // namespace hexapod
