#pragma once

#include <vector>

#include "robot/robot_description.h"

namespace hexapod {

/// The neutral pose with every joint of the second control signal moved by amplitude * signal,
/// within its limits: both outer joints of a leg fold and the tibia stays upright.
std::vector<double> sittingPose(const RobotDescription& robot, double signal);

}  // namespace hexapod
