#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "robot/robot_description.h"

namespace hexapod {

/// Poses of all bodies in the frame of the base, at the given joint angles [rad, in joint order]:
/// the base itself (identity) first, then the segments in joint order.
std::vector<Eigen::Isometry3d> baseFromBodies(const RobotDescription& robot,
                                              const std::vector<double>& angles_rad);

/// The bodies in the order of baseFromBodies(); pointers into the description.
std::vector<const Body*> bodies(const RobotDescription& robot);

/// Height [m] of the lowest point of a shape posed in a frame whose z points up.
double lowestPoint(const Shape& shape, const Eigen::Isometry3d& world_from_shape);

/// Height [m] of the base's origin when the robot is put on the floor in its neutral pose, level,
/// with its lowest shape just touching. Throws std::invalid_argument when it has no shape at all.
double standingHeight(const RobotDescription& robot);

}  // namespace hexapod
