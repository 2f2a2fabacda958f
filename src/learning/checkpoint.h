#pragma once

#include <cstdint>
#include <set>

#include "evolution/individual.h"
#include "learning/learning_phase.h"
#include "repertoire/repertoire_file.h"

namespace hexapod {

/// What a learning session is made of besides options, history and executions: with those, which
/// its repertoire holds, all that it needs to go on exactly.
struct Checkpoint {
  EvolutionState evolution;  ///< archive in its own order, entries without executions
  LearningPhase phase = LearningPhase::kEvolving;
  double elapsed_s = 0.0;  ///< spent evolving
  std::int64_t simulations = 0;
  std::set<std::int64_t> dropped;   ///< ids of the archive's entries that the repertoire leaves out
  std::int64_t trial_attempts = 0;  ///< behaviours that the robot was, or was to be, asked for
};

/// The checkpoint as a repertoire file keeps it.
LearnerState toLearnerState(const Checkpoint& checkpoint);

/// Puts the checkpoint together again from a file's content. Throws std::invalid_argument with a
/// sentence naming the value that is missing or wrong, what was expected and what was found.
Checkpoint checkpointFrom(const StoredRepertoire& stored);

}  // namespace hexapod
