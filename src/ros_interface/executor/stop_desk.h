#pragma once

#include <atomic>
#include <string>

#include "execution/shared_executor.h"

namespace hexapod {

/// What e_stop and ~stop do to an executor, without the wire. Neither waits for the command loop:
/// when they return nothing is sent any more. From any thread.
class StopDesk {
 public:
  /// `executor` must outlive it.
  explicit StopDesk(SharedExecutor& executor) : executor_(executor) {}

  /// A message on e_stop: pressed or not; either is a sign of life of its publisher. True when it
  /// was pressed just now.
  bool hear(bool pressed);

  /// ~stop; its answer as a sentence.
  std::string stop();

 private:
  SharedExecutor& executor_;
  std::atomic<bool> pressed_{false};  // as last heard
};

}  // namespace hexapod
