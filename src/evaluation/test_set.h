#pragma once

#include <vector>

#include "robot/robot_description.h"
#include "simulation/world.h"

namespace hexapod {

/// The worlds that repertoires are judged by: 20 draws in which all differs at once, and by more
/// than learning varies it: friction and servo gain by 30 %, masses by 15 %, torque by -20 .. +15
/// %, slopes of either axis by half a degree, as floors have that pass for level, commands up to 30
/// ms late, steps that the command period is 6 to 10 times as long as (3 to 5 ms of 30). Of every
/// quantity each world has its own one of 20 equal parts of the range. Always the same ones;
/// nothing learns in them, and no option is chosen by them.
std::vector<Physics> testSet(const Physics& nominal, double command_period_s);

}  // namespace hexapod
