#include "ros_interface/robot_client/executor_client.h"

#include <cmath>
#include <utility>

#include "ros_interface/robot_client/patience.h"

namespace hexapod {
namespace {

using State = hexapod_repertoire::ExecutorState;

// The executor's state comes once a second, whatever ROS time does.
constexpr std::int64_t kSilence_ns = 17 * kSecond_ns / 10;
constexpr std::int64_t kPoll_ns = kSecond_ns / 20;
// What is broken off is answered when the robot has come to rest; who leaves waits no longer than
// this, and nobody waits while simulated time stands.
constexpr std::int64_t kBreakOff_ns = kSecond_ns / 2;
constexpr std::int64_t kStands_ns = kSecond_ns / 10;
// To stand up, or to come to rest after a behaviour that was broken off.
constexpr double kReady_s = 5.0;
// Without feedback, which comes five times a second.
constexpr double kProgress_s = 3.0;

const char* const kTimeStandsMessage =
    "Simulated time stands still; see that the simulation runs and publishes /clock, then send the "
    "goal again.";

bool needsAPerson(std::uint8_t state) {
  return state == State::DISARMED || state == State::STOPPED || state == State::FAULT ||
         state == State::SITTING_DOWN;
}

std::string advice(const State& state) {
  switch (state.state) {
    case State::STOPPED:
      return "The executor is stopped (" + state.reason +
             "); release the emergency stop, then call executor/arm and send the goal again.";
    case State::FAULT:
      return "The executor reports a fault (" + state.reason +
             "); mend it, then call executor/arm and send the goal again.";
    case State::SITTING_DOWN:
      return "The robot sits down (" + state.reason +
             "); then call executor/arm and send the goal again.";
    default:
      return "The executor is disarmed (" + state.reason +
             "); call executor/arm and send the goal again.";
  }
}

// By the status first: a goal that its cancel overtook ends RECALLED with an empty result, whose
// code reads as success.
BehaviorPlayer::End endOf(const hexapod_repertoire::ExecuteBehaviorActionResult& answer) {
  using Status = actionlib_msgs::GoalStatus;
  using Result = hexapod_repertoire::ExecuteBehaviorResult;
  const std::uint8_t status = answer.status.status;
  if (status == Status::PREEMPTED || status == Status::RECALLED) {
    return BehaviorPlayer::End::kCancelled;
  }
  if (status == Status::SUCCEEDED || answer.result.code == Result::SKIPPED) {
    return BehaviorPlayer::End::kPlayed;
  }
  return answer.result.code == Result::NOT_READY ? BehaviorPlayer::End::kNotReady
                                                 : BehaviorPlayer::End::kFault;
}

std::vector<JointRange> jointsOf(const hexapod_repertoire::ExecuteBehaviorResult& result) {
  std::vector<JointRange> joints;
  if (result.joint_min_rad.size() != result.joint_max_rad.size()) return joints;
  for (std::size_t j = 0; j < result.joint_min_rad.size(); ++j) {
    joints.push_back({result.joint_min_rad[j], result.joint_max_rad[j]});
  }
  return joints;
}

}  // namespace

ExecutorClient::ExecutorClient(const Clock& clock, ExecutorWire& wire, std::string name)
    : clock_(clock), wire_(wire), name_(std::move(name)), silence_(clock) {}

std::string ExecutorClient::whySilent() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool heard = silence_.look_ns() <= kSilence_ns && state_;
  if (heard && wire_.isConnected()) return "";
  return state_ ? "The executor is silent; it is gone or hangs. Start it again, call executor/arm "
                  "and send the goal again."
                : "No executor answers on executor/state; start the executor node.";
}

std::string ExecutorClient::whyNotReady() const {
  std::string silent = whySilent();
  if (!silent.empty()) return silent;
  const std::lock_guard<std::mutex> lock(mutex_);
  return needsAPerson(state_->state) ? advice(*state_) : "";
}

std::optional<ros::Time> ExecutorClient::readySince() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return state_ && state_->state == State::READY ? std::optional(ready_) : std::nullopt;
}

BehaviorPlayer::Result ExecutorClient::play(const Order& order) {
  Patience patience(clock_, kReady_s);
  while (true) {
    Result result = awaitReady(order.stops, order.interrupted);
    if (result.end != End::kPlayed) return result;
    result = playOnce(order);
    // Between its state and our goal somebody else may have come first.
    if (result.end != End::kNotReady || patience.verdict() != Patience::Verdict::kWait) {
      return result;
    }
    clock_.waitUntil(clock_.steadyNow_ns() + kPoll_ns, order.interrupted);
  }
}

BehaviorPlayer::Result ExecutorClient::awaitReady(std::uint64_t stops,
                                                  const Interrupted& interrupted) {
  Patience patience(clock_, kReady_s);
  const auto notReady = [](const std::string& why) { return Result{End::kNotReady, why, {}, 0}; };
  while (true) {
    if (interrupted()) return {End::kCancelled, "Broken off before it began.", {}, 0};
    if (stops_ != stops) {
      const std::string why = whyNotReady();
      return notReady(
          why.empty() ? "The executor was stopped after the goal was given; send it again." : why);
    }
    const std::string silent = whySilent();
    if (!silent.empty()) return notReady(silent);
    if (const auto since = readySince()) return {End::kPlayed, "", *since, 0};
    const Patience::Verdict verdict = patience.verdict();
    if (verdict == Patience::Verdict::kTimeStands) {
      return {End::kTimeStands, kTimeStandsMessage, {}, 0};
    }
    if (verdict == Patience::Verdict::kTooLong) {
      return notReady("The executor did not become ready in time; see executor/state.");
    }
    clock_.waitUntil(clock_.steadyNow_ns() + kPoll_ns,
                     [&] { return readySince() || interrupted(); });
  }
}

BehaviorPlayer::Result ExecutorClient::playOnce(const Order& order) {
  hexapod_repertoire::ExecuteBehaviorActionGoal goal;
  goal.goal_id.stamp = clock_.rosNow();
  goal.goal_id.id =
      name_ + "-" + std::to_string(++goals_) + "-" + std::to_string(clock_.steadyNow_ns());
  goal.header.stamp = goal.goal_id.stamp;
  goal.goal.entry_id = order.run_id.empty() ? -1 : order.entry.id;
  goal.goal.genome = order.entry.genome;
  goal.goal.run_id = order.run_id;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    goal_id_ = goal.goal_id.id;
    answer_.reset();
  }
  wire_.send(goal);
  return awaitEnd(goal.goal_id, order.interrupted);
}

BehaviorPlayer::Result ExecutorClient::awaitEnd(const actionlib_msgs::GoalID& id,
                                                const Interrupted& interrupted) {
  Patience patience(clock_, kProgress_s);
  std::uint64_t signs = signs_;
  while (true) {
    if (const auto end = ended()) return *end;
    if (interrupted()) return breakOff(id);
    const std::string silent = whySilent();
    if (!silent.empty()) return {End::kFault, silent, {}, 0};
    if (signs != signs_) patience.renew();
    signs = signs_;
    const Patience::Verdict verdict = patience.verdict();
    if (verdict == Patience::Verdict::kTimeStands) {
      wire_.cancel(id);
      return {End::kTimeStands, kTimeStandsMessage, {}, 0};
    }
    if (verdict == Patience::Verdict::kTooLong) {
      wire_.cancel(id);
      return {End::kFault,
              "The executor tells nothing of the behaviour it plays; see "
              "executor/state.",
              {},
              0};
    }
    clock_.waitUntil(clock_.steadyNow_ns() + kPoll_ns, [&] { return ended() || interrupted(); });
  }
}

BehaviorPlayer::Result ExecutorClient::breakOff(const actionlib_msgs::GoalID& id) {
  wire_.cancel(id);
  const std::int64_t begin_ns = clock_.steadyNow_ns();
  const ros::Time begin = clock_.rosNow();
  clock_.waitUntil(begin_ns + kBreakOff_ns, [&] {
    return ended() || (clock_.steadyNow_ns() - begin_ns > kStands_ns && clock_.rosNow() == begin);
  });
  return ended().value_or(Result{End::kCancelled, "Broken off.", {}, 0});
}

std::optional<BehaviorPlayer::Result> ExecutorClient::ended() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!answer_) return std::nullopt;
  const std::string& message = answer_->result.message;
  return Result{endOf(*answer_), message.empty() ? answer_->status.text : message,
                answer_->result.finished, answer_->result.skipped, jointsOf(answer_->result)};
}

void ExecutorClient::onState(const State& state) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool stopped = needsAPerson(state.state);
  if (stopped && !(state_ && needsAPerson(state_->state))) ++stops_;
  if (!state_ || state_->state != state.state) ready_ = state.header.stamp;
  state_ = state;
  silence_.end();
}

void ExecutorClient::onStatus(const actionlib_msgs::GoalStatusArray& status) {
  const std::lock_guard<std::mutex> lock(mutex_);
  silence_.end();
  for (const actionlib_msgs::GoalStatus& goal : status.status_list) {
    if (goal.goal_id.id == goal_id_ && goal.status == actionlib_msgs::GoalStatus::PENDING) ++signs_;
  }
}

void ExecutorClient::onFeedback(const hexapod_repertoire::ExecuteBehaviorActionFeedback& feedback) {
  const std::lock_guard<std::mutex> lock(mutex_);
  silence_.end();
  if (feedback.status.goal_id.id == goal_id_) ++signs_;
}

void ExecutorClient::onResult(const hexapod_repertoire::ExecuteBehaviorActionResult& result) {
  const std::lock_guard<std::mutex> lock(mutex_);
  silence_.end();
  if (result.status.goal_id.id == goal_id_) answer_ = result;
}

}  // namespace hexapod
