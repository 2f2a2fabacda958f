#pragma once

#include <cstddef>
#include <cstdint>

#include "robot/robot_description.h"

namespace hexapod {

/// How a robot did with a small repertoire of its own.
struct Walks {
  std::size_t entries = 0;
  int goals = 0;
  int reached = 0;
  int falls = 0;
};

/// Learns with the default preset, validates, and walks to five goals around the robot, as far away
/// as suits its legs, planning anew after every behaviour, in the fast engine.
Walks learnAndWalk(const RobotDescription& robot, std::int64_t evaluations);

}  // namespace hexapod
