#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "gait/behavior.h"
#include "geometry/pose2.h"
#include "simulation/world.h"

namespace hexapod {

/// Where the robot is at one moment of a behaviour.
struct RecordedPose {
  Eigen::Isometry3d world_from_base;
  std::vector<double> angles_rad;  ///< in joint order
};

struct Recording {
  Pose2 world_from_start;           ///< footprint before the behaviour
  std::vector<RecordedPose> poses;  ///< after each command
};

/// Plays a behaviour from the settled stand. When it fails the poses are those until then. Latency
/// is left out: nothing is sent to anybody here.
/// Throws std::invalid_argument when the command period is not a multiple of the world's step.
Recording record(World& world, const Behavior& behavior, double command_period_s);

}  // namespace hexapod
