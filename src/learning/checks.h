#pragma once

#include <vector>

#include "evaluation/robust_worlds.h"
#include "learning/learning_phase.h"
#include "learning/learning_run.h"

namespace hexapod {

/// A look at a run's entries after evolution. It changes nothing; what it finds is for
/// LearningRun::add().
struct Check {
  LearningPhase phase;
  bool (*is_wanted)(const LearningRun& run);
  /// How many of the run's simulations take about as long.
  double (*cost)(const LearningRun& run);
  /// The hooks are told of the behaviours it plays. Throws EvaluationCancelled.
  Findings (*find)(const LearningRun& run, const PlayHooks& hooks);
};

/// The checks in the order in which they are made, which is that of their phases: verification in
/// ODE, validation of what holds, worlds that learning does not use, what a robot does of them.
const std::vector<Check>& checks();

/// What is left in worlds that learning does not use of the entries as they are now, told as
/// held_out and facts. Throws EvaluationCancelled.
Findings tryOtherWorlds(const LearningRun& run, const PlayHooks& hooks);

}  // namespace hexapod
