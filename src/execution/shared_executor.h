#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <vector>

#include "execution/command_mailbox.h"
#include "execution/executor_core.h"
#include "execution/leg_doubts.h"
#include "execution/triple_buffer.h"

namespace hexapod {

/// An ExecutorCore between a command loop, a thread that sends and the threads of callbacks.
///
/// The loop thread calls serve() and tick(): neither allocates, locks, waits nor does I/O. What is
/// to be sent goes to the sending thread, which always takes the newest command: one that was not
/// sent in its period counts as skipped. All other functions are for any other threads. Requests
/// wait until the loop has judged them, one command period at most while it runs, and return its
/// answer.
class SharedExecutor {
 public:
  using Send = std::function<void(const OutgoingCommand&)>;

  SharedExecutor(const RobotDescription& robot, const BehaviorOptions& behavior,
                 const ExecutorOptions& options);

  /// As in ExecutorCore. Reason::kNoAnswer when the loop does not answer within a second (the
  /// request is then withdrawn), kOvertaken when a stop came in between.
  /// @{
  Cause arm() { return ask({Request::kArm}); }
  Cause stand() { return ask({Request::kStand}); }
  Cause sit() { return ask({Request::kSit}); }
  Cause disarm();
  Cause start(const Behavior& behavior, std::int64_t entry_id) {
    return ask({Request::kStart, Reason::kNone, &behavior, entry_id});
  }
  Cause cancel(Reason why) { return ask({Request::kCancel, why}); }
  /// Replaces what was tolerated before.
  Cause tolerate(const JointTolerance& tolerance);
  /// @}

  /// When these return, nothing is sent any more until arm(), whatever was under way to the sending
  /// thread; with hold_on_stop one command follows, the last. Never waits for the loop's period.
  /// @{
  void stop(Reason why);
  void setEStop(bool pressed);
  /// @}

  void feedback(const JointReadings& readings);
  ExecutorStatus status();
  /// Indices of the joints that are believed dead.
  std::vector<std::size_t> toleratedJoints() const;

  /// Loop thread: carries out what was asked. Called while waiting for a slot that does not come.
  void serve();
  /// Loop thread: serve(), then one command period, whose nominal time is `stamp_ns`.
  void tick(std::int64_t slot, std::int64_t stamp_ns);
  /// Loop thread.
  ExecutorMode modeInLoop() const { return core_.status().mode; }

  /// Sending thread: waits for a command and has `send` send it, unless a stop came in between.
  /// False once stopSending() was called.
  bool sendNext(const Send& send);
  /// Lets the sending thread go.
  void stopSending() { mailbox_.close(); }

 private:
  struct Request {
    enum Kind { kArm, kStand, kSit, kDisarm, kStart, kCancel, kTolerate };
    Kind kind = kDisarm;
    Reason why = Reason::kNone;
    const Behavior* behavior = nullptr;
    std::int64_t entry_id = -1;
    const std::vector<char>* dead = nullptr;
    bool watched = false;
    std::uint64_t stops = 0;  // seen when it was made
  };
  enum class Desk { kEmpty, kPosted, kTaken, kAnswered };

  Cause ask(Request request);
  Cause carryOut(const Request& request);
  void noteSilence();

  ExecutorCore core_;             // loop thread
  std::uint64_t stops_seen_ = 0;  // loop thread
  std::uint64_t beats_seen_ = 0;  // loop thread
  bool sends_ = false;            // loop thread: the core did when last looked at
  std::atomic<std::uint64_t> stops_{0};
  std::atomic<std::uint64_t> beats_{0};     // of the emergency stop's publisher
  std::atomic<std::uint64_t> silences_{0};  // times the core stopped sending by itself
  std::atomic<Reason> stop_reason_{Reason::kStopRequested};
  std::atomic<bool> e_stop_{false};
  CommandMailbox mailbox_;  // from loop to sending thread
  std::atomic<bool> sending_{false};
  std::atomic<std::uint64_t> overtaken_{0};  // commands that were never sent, not yet told the core

  std::mutex ask_mutex_;  // callers: one request at a time
  std::atomic<Desk> desk_{Desk::kEmpty};
  Request request_;  // the caller's while kEmpty or kAnswered, the loop's while kTaken
  Cause answer_;

  mutable std::mutex tolerated_mutex_;
  std::vector<std::size_t> tolerated_;  // guarded by tolerated_mutex_
  std::mutex feedback_mutex_;           // callers: the writing end
  TripleBuffer<JointReadings> feedback_;
  std::mutex status_mutex_;  // callers: the reading end
  TripleBuffer<ExecutorStatus> status_;
};

}  // namespace hexapod
