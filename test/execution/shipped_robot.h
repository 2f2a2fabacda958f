#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/random.h"
#include "execution/joint_readings.h"
#include "gait/genome.h"
#include "robot/load_robot.h"

namespace hexapod {

/// Of commands, as in the paper.
constexpr double kPeriod_s = 0.030;

inline const RobotDescription& shippedRobot() {
  static const RobotDescription robot = loadRobot("urdf/hexapod.urdf", "config/hexapod.yaml");
  return robot;
}

/// A driver that reads all joints at once.
class WholeRobotDriver {
 public:
  const JointReadings& read(const std::vector<double>& angles_rad) {
    readings_.angles_rad = angles_rad;
    for (std::uint64_t& count : readings_.counts) ++count;
    return readings_;
  }

 private:
  JointReadings readings_{shippedRobot().jointCount()};
};

/// Largest difference of any joint [rad].
inline double largestStep(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t j = 0; j < a.size(); ++j) largest = std::max(largest, std::abs(a[j] - b[j]));
  return largest;
}

}  // namespace hexapod
