#pragma once

#include <string>
#include <vector>

#include "hexapod_repertoire/Disturb.h"
#include "robot/robot_description.h"
#include "simulation/world.h"

namespace hexapod {

/// What is wrong with a simulated robot: its body and floor, its commands, its feedback.
struct Disturbance {
  Physics physics;
  double latency_s = 0.0;           ///< commands act so much later
  double dropped_share = 0.0;       ///< of the commands, lost
  double feedback_noise_rad = 0.0;  ///< standard deviation, on reported joint angles
  double dead_band_rad = 0.0;       ///< a command nearer to the joint's angle does not move it
};

/// What a call asks for, beside what the robot was started with. `angles_rad`: where its joints are
/// now, in joint order. Throws std::invalid_argument with a sentence that names the field, what was
/// found and what was expected.
Disturbance disturbanceFrom(const hexapod_repertoire::Disturb::Request& request,
                            const Disturbance& started_with, const RobotDescription& robot,
                            const std::vector<double>& angles_rad);

/// A sentence.
std::string describe(const Disturbance& disturbance, const RobotDescription& robot);

}  // namespace hexapod
