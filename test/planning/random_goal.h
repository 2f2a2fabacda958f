#pragma once

#include "common/random.h"
#include "planning/planner.h"

namespace hexapod {

inline PlanRequest requestTo(const Pose2& goal) {
  PlanRequest request;
  request.world_from_goal = goal;
  return request;
}

/// Evenly distributed over a disc, any heading.
inline Pose2 randomPose(Random& random, double radius_m) {
  const double far_m = radius_m * std::sqrt(random.uniform());
  const double direction_rad = random.uniform(-M_PI, M_PI);
  return {far_m * std::cos(direction_rad), far_m * std::sin(direction_rad),
          random.uniform(-M_PI, M_PI)};
}

}  // namespace hexapod
