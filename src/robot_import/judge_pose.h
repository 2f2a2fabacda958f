#pragma once

#include <vector>

#include "robot_import/leg_model.h"

namespace hexapod {

/// Which signal moves each joint of a leg: 1, 2 or none of them (0).
using SignalShares = std::vector<int>;

/// What a leg's poses are judged for.
struct StandingTask {
  double load_n = 0.0;             ///< that the foot carries
  double belly_m = 0.0;            ///< lowest point of the base, in its frame
  double clearance_m = 0.0;        ///< that is wanted below it
  Eigen::Vector2d middle_m{0, 0};  ///< of the hips
  double scale = 1.0;              ///< of stroke and lift
};

/// A pose with a gait, and how good they are.
struct JudgedPose {
  std::vector<double> angles_rad;
  std::vector<double> amplitudes_rad;  ///< of each joint's own signal, signed
  double score = -1e9;
  double floor_m = 0.0;       ///< height of the foot's lowest point, in the base
  double torque_share = 0.0;  ///< of the most loaded joint's torque that standing takes
};

/// Whether a leg stands ahead of the robot's middle or behind it, on neither side.
bool isOnAxis(const LegModel& leg, const StandingTask& task);

/// See chooseGait() for what makes a pose good.
JudgedPose judgePose(const LegModel& leg, const StandingTask& task, const SignalShares& shares,
                     const std::vector<double>& angles_rad);

}  // namespace hexapod
