#include "ros_interface/executor/behavior_goals.h"

#include <ros/console.h>

#include <exception>
#include <utility>

#include "ros_interface/executor/behavior_result.h"

namespace hexapod {
namespace {

constexpr double kFeedbackPeriod_s = 0.2;

}  // namespace

void BehaviorGoals::take(const std::string& id, const hexapod_repertoire::ExecuteBehaviorGoal& goal,
                         std::unique_ptr<GoalSender> sender) {
  const ExecutorStatus status = means_.executor.status();
  poll(status);  // a goal whose behaviour has just ended is answered before another takes its place
  // A burst of goals while one is played costs the command loop nothing.
  if (status.mode != ExecutorMode::kReady) {
    return refuse(*sender, Result::NOT_READY,
                  sentence({Reason::kNotReady, status.mode}, means_.joint_names));
  }
  std::string problem;
  std::shared_ptr<const Behavior> behavior;
  try {
    behavior = means_.behaviors.find(goal, problem);
  } catch (const std::exception& error) {
    problem = error.what();
  }
  if (!behavior) return refuse(*sender, Result::INVALID_GOAL, problem);
  const Cause cause = means_.executor.start(*behavior, goal.entry_id);
  if (!cause.accepted()) {
    return refuse(*sender, Result::NOT_READY, sentence(cause, means_.joint_names));
  }
  if (means_.ranges != nullptr) means_.ranges->begin();
  sender_ = std::move(sender);
  id_ = id;
  serial_ = means_.executor.status().serial;
  behavior_ = std::move(behavior);
  next_feedback_s_ = 0.0;
  sender_->accepted();
}

void BehaviorGoals::cancel(const std::string& id) {
  if (!sender_ || id != id_) return;
  // A behaviour that has just come to its end is not broken off any more; poll() tells.
  means_.executor.cancel(Reason::kCancelled);
}

void BehaviorGoals::refuse(GoalSender& sender, std::uint8_t code, const std::string& message) {
  Result result;
  result.code = code;
  result.message = message;
  ROS_WARN_STREAM("Goal refused: " << message);
  sender.refused(result);
}

void BehaviorGoals::poll(const ExecutorStatus& status) {
  if (!sender_) return;
  if (status.last_end.serial >= serial_) return finish(status.last_end);
  const double elapsed_s = static_cast<double>(status.played) * means_.command_period_s;
  if (elapsed_s < next_feedback_s_) return;
  next_feedback_s_ = elapsed_s + kFeedbackPeriod_s;
  hexapod_repertoire::ExecuteBehaviorFeedback feedback;
  feedback.elapsed_s = static_cast<float>(elapsed_s);
  feedback.duration_s = static_cast<float>(behavior_->duration_s());
  sender_->feedback(feedback);
}

void BehaviorGoals::finish(const BehaviorEnd& end) {
  Result result = behaviorResult(end, behavior_->commandCount(), means_.joint_names);
  result.finished = means_.stamp(end.last_slot);
  if (means_.ranges != nullptr) {
    result.joint_min_rad = means_.ranges->min_rad();
    result.joint_max_rad = means_.ranges->max_rad();
  }
  this->end(result);
}

void BehaviorGoals::abort(const std::string& why) {
  if (!sender_) return;
  Result result;
  result.code = Result::STOPPED;
  result.message = why;
  end(result);
}

// The behaviour stays until another is taken: of a goal that was aborted the executor plays on.
void BehaviorGoals::end(const Result& result) { std::exchange(sender_, nullptr)->ended(result); }

}  // namespace hexapod
