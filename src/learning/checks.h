#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "learning/learning_phase.h"
#include "learning/learning_run.h"

namespace hexapod {

/// What a check is told, and tells, while it works.
struct CheckHooks {
  /// Called with what is done and what there is to do, by any thread, one at a time.
  std::function<void(std::size_t, std::size_t)> progress;
  const std::atomic<bool>& cancelled;
};

/// A look at a run's entries after evolution. It changes nothing; what it finds is for
/// LearningRun::add().
struct Check {
  LearningPhase phase;
  bool (*is_wanted)(const LearningRun& run);
  /// Nothing when it was cancelled.
  std::optional<Findings> (*find)(const LearningRun& run, const CheckHooks& hooks);
};

/// The checks in the order in which they are made: verification in ODE, validation of what holds,
/// worlds that learning does not use.
const std::vector<Check>& checks();

/// What is left in worlds that learning does not use of the entries as they are now, told as
/// held_out and facts. Nothing when it was cancelled.
std::optional<Findings> tryOtherWorlds(const LearningRun& run, const CheckHooks& hooks);

}  // namespace hexapod
