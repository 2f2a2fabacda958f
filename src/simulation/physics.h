#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

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
/// gain and torques, and its legs in their states: a limp one's joints stand still with little
/// torque, a missing one has hardly any mass and no shape. Its digest is still the original's.
/// Throws std::invalid_argument when the number of legs, joints or locked angles is another.
RobotDescription underPhysics(const RobotDescription& robot, const Physics& physics);

/// Whether a touch of this leg and another is Verdict::kSelfCollided (LegState).
bool touchCounts(const Physics& physics, std::size_t leg);

/// How many steps later than sent a command acts.
std::size_t latencySteps(const Physics& physics);

/// What becomes of commanded joint targets in a body some of whose legs hold an angle.
class HeldJoints {
 public:
  /// Throws as underPhysics() does.
  HeldJoints(const RobotDescription& robot, const Physics& physics);

  bool any() const { return !held_.empty(); }

  /// Overwrites the targets [rad, in joint order] of joints that are held.
  void apply(std::vector<double>& targets_rad) const;

 private:
  struct Held {
    std::size_t joint;
    double angle_rad;
  };
  std::vector<Held> held_;
};

/// Gravity [m/s^2] in the frame of the floor, whose z is the floor's normal. The slopes are those
/// of the floor along its x and y axes, so straight down is along (-tan slope_x, -tan slope_y, -1).
Eigen::Vector3d gravityOnFloor(const Physics& physics);

/// True when a link's state is not finite or beyond what a robot can do: Verdict::kDiverged.
bool isAbsurd(const Eigen::Vector3d& position_m, const Eigen::Vector3d& velocity_m_per_s,
              const Eigen::Vector3d& rate_rad_per_s);

}  // namespace hexapod
