#pragma once

#include <Eigen/Core>

#include "robot/robot_description.h"
#include "simulation/world.h"

namespace hexapod {

/// What every engine shares of the rules a world follows (world.h).

/// The settling at construction: long enough to come to rest, at a step fine enough to do so
/// softly.
constexpr double kSettlingTime_s = 1.0;
constexpr double kSettlingStep_s = 0.001;

/// No link of a robot moves faster than this unless the simulation has blown up.
constexpr double kAbsurdSpeed_m_per_s = 100.0;
constexpr double kAbsurdRate_rad_per_s = 1000.0;

/// Throws std::invalid_argument naming the value, the allowed range and what was found.
void checkPhysics(const Physics& physics);

/// A copy of the robot with the scales of `physics` applied to masses, inertias, friction, servo
/// gain and torques. Its digest is still the original's.
RobotDescription underPhysics(const RobotDescription& robot, const Physics& physics);

/// Gravity [m/s^2] in the frame of the floor, whose z is the floor's normal. The slopes are those
/// of the floor along its x and y axes, so straight down is along (-tan slope_x, -tan slope_y, -1).
Eigen::Vector3d gravityOnFloor(const Physics& physics);

/// True when a link's state is not finite or beyond what a robot can do: Verdict::kDiverged.
bool isAbsurd(const Eigen::Vector3d& position_m, const Eigen::Vector3d& velocity_m_per_s,
              const Eigen::Vector3d& rate_rad_per_s);

}  // namespace hexapod
