#pragma once

#include <limits>

#include "repertoire/entry.h"

namespace hexapod {

/// Which entries somebody wants to see; as it is made: all.
struct EntryFilter {
  double max_orientation_error_rad = std::numeric_limits<double>::infinity();
  double max_spread_m = std::numeric_limits<double>::infinity();

  /// By the pose that a planner expects. What was not validated has no spread that could be too
  /// large.
  bool passes(const Entry& entry) const {
    if (orientationError(entry.expectedPose()) > max_orientation_error_rad) return false;
    return !entry.execution || entry.execution->spread_m <= max_spread_m;
  }
};

}  // namespace hexapod
