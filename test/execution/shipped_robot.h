#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/random.h"
#include "gait/genome.h"
#include "robot/load_robot.h"

namespace hexapod {

inline const RobotDescription& shippedRobot() {
  static const RobotDescription robot = loadRobot("urdf/hexapod.urdf", "config/hexapod.yaml");
  return robot;
}

inline Genome randomGenome(Random& random) {
  Genome genome(shippedRobot().geneCount());
  for (auto& gene : genome) gene = static_cast<std::uint8_t>(random.below(kGeneLevels));
  return genome;
}

/// Largest difference of any joint [rad].
inline double largestStep(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t j = 0; j < a.size(); ++j) largest = std::max(largest, std::abs(a[j] - b[j]));
  return largest;
}

}  // namespace hexapod
