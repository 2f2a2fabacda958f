#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "common/random.h"
#include "gait/genome.h"
#include "ros_interface/common/clock.h"

namespace hexapod {

constexpr std::int64_t kPeriod_ns = 30'000'000;
constexpr double kSame_rad = 1e-6;
constexpr std::int64_t kForever = std::numeric_limits<std::int64_t>::max();

inline double steadyNow_s() { return 1e-9 * static_cast<double>(steadyNow_ns()); }

/// What was seen, and what of it should not have been.
struct Tally {
  int stops = 0;
  int walking = 0;        // stops that found a behaviour under way
  int late = 0;           // stops after which a command was sent
  int old_after_arm = 0;  // armings after which an old set-point came
  std::int64_t latest_periods = 0;
};

// Is every joint somewhere on the straight way from one pose to another?
inline bool onTheWay(const std::vector<double>& from, const std::vector<double>& to,
                     const std::vector<double>& pose) {
  for (std::size_t j = 0; j < pose.size(); ++j) {
    if (pose[j] < std::min(from[j], to[j]) - kSame_rad) return false;
    if (pose[j] > std::max(from[j], to[j]) + kSame_rad) return false;
  }
  return true;
}

}  // namespace hexapod
