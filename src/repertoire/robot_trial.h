#pragma once

#include <cstdint>
#include <optional>

#include "gait/genome.h"
#include "geometry/pose2.h"

namespace hexapod {

/// A controller that was tried on the robot while a repertoire was learned.
struct RobotTrial {
  std::int64_t evaluation = 0;  ///< candidates evaluated when it was tried
  Genome genome;
  Pose2 simulated;                ///< end pose as learned, in the frame of the start
  double cost = 0.0;              ///< and its cost, see Outcome
  std::optional<Pose2> measured;  ///< where it ended on the robot, likewise; none: it fell
};

}  // namespace hexapod
