#pragma once

#include <string>

#include "hexapod_repertoire/Repertoire.h"

namespace hexapod {

/// What is wrong with a repertoire that is published while this robot (digest of its description)
/// is simulated, as a sentence, or empty: planner and executor may have been given other files.
std::string wrongRobot(const hexapod_repertoire::Repertoire& repertoire,
                       const std::string& robot_id);

}  // namespace hexapod
