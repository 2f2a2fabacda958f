#pragma once

#include <cstddef>
#include <vector>

#include "planning/plan.h"

namespace hexapod {

/// A pose to pass or to arrive at.
struct Waypoint {
  Pose2 world_from_goal;
  GoalTolerance tolerance;
};

/// What one plan of a route leaves for the next one.
struct RouteMemory {
  struct Leg {
    Waypoint arrival;  ///< the part of the waypoint's tolerance that was chosen to arrive in
    PlanMemory memory;
  };
  std::vector<Leg> legs;  ///< one per waypoint that is still ahead
  std::size_t steps =
      0;  ///< promised for the whole when the arrivals were chosen, less those walked

  /// The first step of the plan was walked.
  void begin();
  /// The first waypoint was passed.
  void pass();
};

/// A chain of plans from waypoint to waypoint.
struct RoutePlan {
  /// One per waypoint in order, each from where the one before ends; ends with the first that is no
  /// success. Never empty.
  std::vector<PlanResult> legs;
  RouteMemory memory;

  bool success() const { return legs.back().success(); }
  std::size_t steps() const;
};

/// Adds a leg to the plan of a route, which begins empty. Of the number of behaviours only what is
/// proved of the first leg holds of the whole.
void append(const PlanResult& leg, PlanResult& whole);

}  // namespace hexapod
