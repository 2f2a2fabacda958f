#pragma once

#include <cstdint>

#include "learning/learning_phase.h"
#include "learning/learning_run.h"

namespace hexapod {

/// How far the check under way is.
struct CheckProgress {
  double elapsed_s = 0.0;
  std::int64_t checked = 0;
  std::int64_t to_check = 0;
};

/// An estimate of how long a run that is in `phase` still takes, its checks included [s]: evolution
/// is as fast as it was so far, the check under way goes on as it began, and later ones take as
/// long as the simulations that they are worth. 0 once all is done or nothing is known yet.
double timeLeft_s(const LearningRun& run, LearningPhase phase, const CheckProgress& check);

}  // namespace hexapod
