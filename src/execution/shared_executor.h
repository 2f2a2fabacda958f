#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <vector>

#include "execution/executor_core.h"
#include "execution/triple_buffer.h"

namespace hexapod {

/// An ExecutorCore between a command loop and the threads of callbacks.
///
/// The loop thread calls serve() and tick(): neither allocates, locks nor waits. All other
/// functions are for any other threads. Requests wait until the loop has judged them, one command
/// period at most while it runs, and return its answer.
class SharedExecutor {
 public:
  using Send = std::function<void(const std::vector<double>&)>;

  SharedExecutor(const RobotDescription& robot, const BehaviorOptions& behavior,
                 const ExecutorOptions& options);

  /// As in ExecutorCore. Reason::kNoAnswer when the loop does not answer within a second (the
  /// request is then withdrawn), kOvertaken when a stop came in between.
  /// @{
  Cause arm() { return ask({Request::kArm}); }
  Cause stand() { return ask({Request::kStand}); }
  Cause sit() { return ask({Request::kSit}); }
  Cause disarm() { return ask({Request::kDisarm}); }
  Cause start(const Behavior& behavior, std::int64_t entry_id) {
    return ask({Request::kStart, Reason::kNone, &behavior, entry_id});
  }
  Cause cancel(Reason why) { return ask({Request::kCancel, why}); }
  /// @}

  /// When these return, nothing is sent any more until arm(). Never waits for the loop's period.
  /// @{
  void stop(Reason why);
  void setEStop(bool pressed);
  /// @}

  void feedback(const std::vector<double>& measured_rad);
  ExecutorStatus status();

  /// Loop thread: carries out what was asked. Called while waiting for a slot that does not come.
  void serve();
  /// Loop thread: serve(), then one command period; `send` gets the command when there is one.
  void tick(std::int64_t slot, const Send& send);
  /// Loop thread.
  ExecutorMode modeInLoop() const { return core_.status().mode; }

 private:
  struct Request {
    enum Kind { kArm, kStand, kSit, kDisarm, kStart, kCancel };
    Kind kind = kDisarm;
    Reason why = Reason::kNone;
    const Behavior* behavior = nullptr;
    std::int64_t entry_id = -1;
    std::uint64_t stops = 0;  // seen when it was made
  };
  enum class Desk { kEmpty, kPosted, kTaken, kAnswered };

  Cause ask(Request request);
  Cause carryOut(const Request& request);

  ExecutorCore core_;             // loop thread
  std::uint64_t stops_seen_ = 0;  // loop thread
  std::atomic<std::uint64_t> stops_{0};
  std::atomic<Reason> stop_reason_{Reason::kStopRequested};
  std::atomic<bool> e_stop_{false};
  std::atomic<bool> sending_{false};

  std::mutex ask_mutex_;  // callers: one request at a time
  std::atomic<Desk> desk_{Desk::kEmpty};
  Request request_;  // the caller's while kEmpty or kAnswered, the loop's while kTaken
  Cause answer_;

  std::mutex feedback_mutex_;  // callers: the writing end
  TripleBuffer<std::vector<double>> feedback_;
  std::mutex status_mutex_;  // callers: the reading end
  TripleBuffer<ExecutorStatus> status_;
};

}  // namespace hexapod
