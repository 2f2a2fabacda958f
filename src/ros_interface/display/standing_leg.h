#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "robot/robot_description.h"

namespace hexapod {

/// Where a leg's joints are and where it ends, from the hip to the foot, in the neutral pose and
/// the frame of the base [m].
std::vector<Eigen::Vector3d> standingLeg(const RobotDescription& robot, std::size_t leg);

}  // namespace hexapod
