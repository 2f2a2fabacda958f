#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hexapod {

/// What is known of the robot's joints, each for itself: joints may be read at different times.
/// Copied between threads without allocating once all vectors have their size.
struct JointReadings {
  explicit JointReadings(std::size_t joint_count)
      : angles_rad(joint_count, 0.0), counts(joint_count, 0) {}

  std::vector<double> angles_rad;     ///< newest reading of each joint, in joint order; finite
  std::vector<std::uint64_t> counts;  ///< readings of each joint so far; 0: angle not known yet
  int contested_joint = -1;           ///< reported by two sources at once; -1: none is
};

}  // namespace hexapod
