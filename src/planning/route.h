#pragma once

#include <functional>

#include "planning/plan.h"

namespace hexapod {

/// A pose to pass or to arrive at.
struct Waypoint {
  Pose2 world_from_goal;
  GoalTolerance tolerance;
};

/// How a goal is planned to.
using PlanFunction = std::function<PlanResult(const PlanRequest&)>;

/// Plans to a waypoint, from `request`'s start (its goal and tolerance are not used), with a look
/// at the one after it, which may be null.
///
/// Where a waypoint leaves its heading open, the cheapest way to arrive is not always the cheapest
/// to go on from: arriving so that the next one lies ahead or behind is taken when both legs
/// together then have fewer behaviours. The next one only chooses between ways to arrive; that it
/// cannot be reached is no reason not to go here.
PlanResult planLeg(const PlanFunction& plan, const PlanRequest& request, const Waypoint& waypoint,
                   const Waypoint* next);

/// Adds a leg to the plan of a route, which begins empty. Of the number of behaviours only what is
/// proved of the first leg holds of the whole.
void append(const PlanResult& leg, PlanResult& whole);

}  // namespace hexapod
