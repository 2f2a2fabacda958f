#pragma once

#include <string>

namespace hexapod {

/// What a learning session is doing.
enum class LearningPhase { kEvolving, kValidating, kDone };

/// "evolving", "validating", "done".
std::string toString(LearningPhase phase);

}  // namespace hexapod
