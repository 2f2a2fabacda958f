#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "geometry/footprint.h"
#include "robot/robot_description.h"

namespace hexapod {

/// The discs of the floor that a robot's shapes cover at a pose of its base and joint angles [rad,
/// in joint order], in the frame of base_footprint: a few per shape, so close that what is between
/// them is less than 3 mm beyond.
std::vector<Disc> coveredDiscs(const RobotDescription& robot,
                               const Eigen::Isometry3d& world_from_base,
                               const std::vector<double>& angles_rad);

/// What body and feet sweep over all gaits while the base is level: every leg at all values of its
/// signals.
Footprint sweptFootprint(const RobotDescription& robot);

}  // namespace hexapod
