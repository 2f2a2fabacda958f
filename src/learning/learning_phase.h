#pragma once

#include <string>

namespace hexapod {

/// What a learning session is doing.
enum class LearningPhase { kEvolving, kVerifying, kValidating, kDone };

/// "evolving", "verifying", "validating", "done".
std::string toString(LearningPhase phase);

}  // namespace hexapod
