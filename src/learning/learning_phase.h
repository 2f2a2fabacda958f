#pragma once

#include <string>

namespace hexapod {

/// What a learning session is doing.
enum class LearningPhase {
  kEvolving,
  kVerifying,
  kValidating,
  kTryingWorlds,
  kTransferring,
  kDone
};

/// "evolving", "verifying", "validating", "trying_worlds", "transferring", "done".
std::string toString(LearningPhase phase);

}  // namespace hexapod
