#include "execution/shared_executor.h"

#include <chrono>
#include <thread>

namespace hexapod {
namespace {

constexpr std::chrono::seconds kAnswerTimeout{1};
constexpr std::chrono::milliseconds kPoll{1};

}  // namespace

SharedExecutor::SharedExecutor(const RobotDescription& robot, const BehaviorOptions& behavior,
                               const ExecutorOptions& options)
    : core_(robot, behavior, options),
      mailbox_(robot.jointCount()),
      feedback_(JointReadings(robot.jointCount())),
      status_(core_.status()) {}

void SharedExecutor::stop(Reason why) {
  stop_reason_ = why;
  ++stops_;
  // A command that was under way when the stop came is out before we return.
  while (sending_) std::this_thread::yield();
}

Cause SharedExecutor::disarm() {
  const Cause cause = ask({Request::kDisarm});
  while (sending_) std::this_thread::yield();
  return cause;
}

Cause SharedExecutor::tolerate(const JointTolerance& tolerance) {
  std::vector<char> flags(feedback_.value().counts.size(), 0);
  for (const std::size_t joint : tolerance.dead) flags.at(joint) = 1;
  Request request{Request::kTolerate};
  request.dead = &flags;
  request.watched = tolerance.watched;
  const Cause cause = ask(request);
  if (!cause.accepted()) return cause;
  const std::lock_guard<std::mutex> lock(tolerated_mutex_);
  tolerated_ = tolerance.dead;
  return cause;
}

std::vector<std::size_t> SharedExecutor::toleratedJoints() const {
  const std::lock_guard<std::mutex> lock(tolerated_mutex_);
  return tolerated_;
}

void SharedExecutor::setEStop(bool pressed) {
  e_stop_ = pressed;
  ++beats_;
  if (pressed) stop(Reason::kEStop);
}

void SharedExecutor::feedback(const JointReadings& readings) {
  const std::lock_guard<std::mutex> lock(feedback_mutex_);
  feedback_.write(readings);
}

ExecutorStatus SharedExecutor::status() {
  const std::lock_guard<std::mutex> lock(status_mutex_);
  status_.update();
  return status_.value();
}

Cause SharedExecutor::ask(Request request) {
  const std::lock_guard<std::mutex> lock(ask_mutex_);
  request.stops = stops_;
  request_ = request;
  desk_ = Desk::kPosted;
  const auto deadline = std::chrono::steady_clock::now() + kAnswerTimeout;
  while (desk_ != Desk::kAnswered) {
    Desk posted = Desk::kPosted;
    if (std::chrono::steady_clock::now() > deadline &&
        desk_.compare_exchange_strong(posted, Desk::kEmpty)) {
      return {Reason::kNoAnswer};
    }
    std::this_thread::sleep_for(kPoll);
  }
  const Cause answer = answer_;
  desk_ = Desk::kEmpty;
  return answer;
}

void SharedExecutor::serve() {
  const std::uint64_t stops = stops_;
  if (stops != stops_seen_) core_.stop(stop_reason_);
  stops_seen_ = stops;
  core_.setEStop(e_stop_);
  const std::uint64_t beats = beats_;
  if (beats != beats_seen_) core_.heartbeat();
  beats_seen_ = beats;
  const std::uint64_t overtaken = overtaken_.exchange(0);
  if (overtaken > 0) core_.overtaken(overtaken);
  if (feedback_.update()) core_.feedback(feedback_.value());
  Desk posted = Desk::kPosted;
  if (desk_.compare_exchange_strong(posted, Desk::kTaken)) {
    answer_ = carryOut(request_);
    noteSilence();
    status_.write(core_.status());
    desk_ = Desk::kAnswered;
    return;
  }
  status_.write(core_.status());
}

Cause SharedExecutor::carryOut(const Request& request) {
  if (request.stops != stops_seen_) return {Reason::kOvertaken};
  switch (request.kind) {
    case Request::kArm:
      return core_.arm();
    case Request::kStand:
      return core_.stand();
    case Request::kSit:
      return core_.sit();
    case Request::kDisarm:
      return core_.disarm();
    case Request::kStart:
      return core_.start(*request.behavior, request.entry_id);
    case Request::kCancel:
      return core_.cancel(request.why);
    case Request::kTolerate:
      core_.tolerate(*request.dead, request.watched);
      return {};
  }
  return {Reason::kNoAnswer};
}

// What the sending thread has not sent when the core falls silent is not to be sent any more.
void SharedExecutor::noteSilence() {
  const bool sends = sendsCommands(core_.status().mode);
  if (sends_ && !sends) ++silences_;
  sends_ = sends;
}

void SharedExecutor::tick(std::int64_t slot, std::int64_t stamp_ns) {
  serve();
  const bool last_word = core_.status().holding;
  const std::vector<double>* command = core_.tick(slot);
  noteSilence();
  if (command != nullptr) {
    mailbox_.post({slot, stamp_ns, stops_seen_, silences_, last_word, {}}, *command);
  }
  status_.write(core_.status());
}

bool SharedExecutor::sendNext(const Send& send) {
  if (!mailbox_.wait()) return false;
  std::uint64_t overtaken = 0;
  const OutgoingCommand* command = mailbox_.take(overtaken);
  overtaken_ += overtaken;
  if (command == nullptr) return true;
  sending_ = true;
  const bool valid = command->stops == stops_ && command->silences == silences_;
  if (valid || command->last_word) send(*command);
  sending_ = false;
  return true;
}

}  // namespace hexapod
