#pragma once

#include <string>

#include "robot/robot_description.h"

namespace hexapod {

/// 16 hexadecimal digits that stand for a description: FNV-1a (64 bits) over every field but
/// `digest`, written as text in a fixed order. Comments and layout of the files play no part.
/// Numbers enter with 12 significant digits, and below 1e-15 as 0: the last bits of a rotation
/// differ between mathematics libraries, and a robot keeps its id on every machine.
std::string digestOf(const RobotDescription& robot);

}  // namespace hexapod
