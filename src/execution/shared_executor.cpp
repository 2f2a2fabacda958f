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
    : core_(robot, behavior, options), feedback_(robot.neutralPose()), status_(core_.status()) {}

void SharedExecutor::stop(Reason why) {
  stop_reason_ = why;
  ++stops_;
  // A command that was under way when the stop came is out before we return.
  while (sending_) std::this_thread::yield();
}

void SharedExecutor::setEStop(bool pressed) {
  e_stop_ = pressed;
  if (pressed) stop(Reason::kEStop);
}

void SharedExecutor::feedback(const std::vector<double>& measured_rad) {
  const std::lock_guard<std::mutex> lock(feedback_mutex_);
  feedback_.write(measured_rad);
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
  if (feedback_.update()) core_.feedback(feedback_.value());
  Desk posted = Desk::kPosted;
  if (desk_.compare_exchange_strong(posted, Desk::kTaken)) {
    answer_ = carryOut(request_);
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
  }
  return {Reason::kNoAnswer};
}

void SharedExecutor::tick(std::int64_t slot, const Send& send) {
  serve();
  const std::vector<double>* command = core_.tick(slot);
  if (command != nullptr) {
    sending_ = true;
    if (stops_ == stops_seen_) send(*command);
    sending_ = false;
  }
  status_.write(core_.status());
}

}  // namespace hexapod
