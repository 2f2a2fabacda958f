#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

#include "gait/behavior.h"
#include "gait/outcome.h"
#include "simulation/world.h"

namespace hexapod {

/// One behaviour to play, the state it starts from, nullptr: the settled stand, and under which of
/// the physics it is played.
struct BatchRun {
  const Behavior* behavior = nullptr;
  const WorldState* start = nullptr;
  std::size_t physics = 0;
};

/// How it ended, and the state it left the robot in.
struct BatchResult {
  Outcome outcome;
  WorldState end;
};

/// Runs that several threads take one by one until none is left, each whenever it has room for
/// another. Who takes which makes no difference to the results. Thread-safe.
class RunQueue {
 public:
  /// `ended`, if given, is called after each run with the number of those that have ended, by any
  /// thread, one at a time. Nothing is taken any more once `cancelled`, if given, is true. All must
  /// outlive the queue.
  explicit RunQueue(const std::vector<BatchRun>& runs,
                    std::function<void(std::size_t)> ended = nullptr,
                    const std::atomic<bool>* cancelled = nullptr);

  const std::vector<BatchRun>& runs() const { return *runs_; }

  /// The number of the next run; nothing when all are taken, or cancelled.
  std::optional<std::size_t> take();

  /// What became of a run that was taken.
  void finish(std::size_t run, BatchResult result);

  /// One result per run, in their order; once nobody plays any more.
  std::vector<BatchResult>& results() { return results_; }

 private:
  const std::vector<BatchRun>* runs_;
  std::function<void(std::size_t)> ended_;
  const std::atomic<bool>* cancelled_;
  std::atomic<std::size_t> next_{0};
  std::vector<BatchResult> results_;
  std::mutex mutex_;  // of count_ended_
  std::size_t count_ended_ = 0;
};

}  // namespace hexapod
