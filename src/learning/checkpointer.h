#pragma once

#include <functional>
#include <string>

#include "repertoire/repertoire_writer.h"

namespace hexapod {

/// Seconds on a clock that never goes back.
using Stopwatch = std::function<double()>;

/// Writes a run's file about as often as it was asked to, and remembers whether the file holds what
/// was last to be saved. One thread at a time.
class Checkpointer {
 public:
  /// Claims the file (see RepertoireWriter); `period_s` 0: always due.
  Checkpointer(const std::string& file, double period_s, Stopwatch clock);

  /// True when the file held a repertoire before anything was saved, or does so now.
  bool holdsRepertoire() const { return writer_.holdsRepertoire(); }

  /// The period has passed since the last try, or since start(), and so much time that writing does
  /// not take more than a hundredth of it.
  bool isDue() const;

  /// The period begins.
  void start() { tried_s_ = clock_(); }

  /// Writes the file. What could not be written is told by problem(), and the next save tries
  /// afresh.
  void save(const Repertoire& repertoire, const LearnerState& state);

  /// Why the last save failed, as a sentence; empty when it did not, or when there was none.
  const std::string& problem() const { return problem_; }

 private:
  double period_s_;
  Stopwatch clock_;
  RepertoireWriter writer_;
  std::string problem_;
  double tried_s_ = 0.0;
  double cost_s_ = 0.0;  // of the last save
};

}  // namespace hexapod
