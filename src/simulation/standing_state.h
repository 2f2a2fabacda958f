#pragma once

#include "robot/robot_description.h"
#include "simulation/world.h"

namespace hexapod {

/// States as both engines have them: per body (base, then segments in joint order) the position of
/// its centre of mass [m], quaternion (w, x, y, z), velocity [m/s] and rate [rad/s]; then the joint
/// targets [rad].
constexpr std::size_t kStateValuesPerBody = 13;

/// The neutral pose, level, at rest, the lowest shape just on the floor, targets neutral.
WorldState standingState(const RobotDescription& robot);

/// Pose of the base's link in a state.
Eigen::Isometry3d baseOf(const RobotDescription& robot, const WorldState& state);

/// The same robot moved over the floor so that its footprint comes to lie at (0, 0) with the given
/// heading. (Headings differ a little: ODE bounds friction along x and along y.)
WorldState footprintAtOrigin(const Eigen::Isometry3d& world_from_base, WorldState state,
                             std::size_t body_count, double heading_rad = 0.0);

/// Throws std::runtime_error: the robot, put on the floor like this, came to that verdict instead
/// of standing still.
[[noreturn]] void throwDoesNotStand(const RobotDescription& robot, Verdict verdict, double time_s);

}  // namespace hexapod
