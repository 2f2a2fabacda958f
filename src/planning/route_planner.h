#pragma once

#include <vector>

#include "planning/adaptive_planner.h"
#include "planning/route.h"

namespace hexapod {

/// Plans through waypoints, all of those still ahead at once: a waypoint that leaves its heading
/// open, or is wide, is arrived at so that the whole route has the fewest behaviours.
///
/// First from waypoint to waypoint, each leg the cheapest for itself. Then by a beam over arrivals:
/// from each of the best beginnings of the route on, the next waypoint is planned to as it is and
/// in those parts of its tolerance that promise most (StepsToGo there and on to the next one); kept
/// are those beginnings that promise the fewest behaviours to the next waypoint. What all of this
/// together may spend is one more planning_time_s. The better of both is the plan, the first where
/// they are equal. With a memory the arrivals chosen before are kept as long as the route through
/// them has as few behaviours as promised; one more is let pass where the next waypoint is far.
/// Deterministic. From any thread.
class RoutePlanner {
 public:
  explicit RoutePlanner(const AdaptivePlanner& planner) : planner_(planner) {}

  /// From `request`'s start; its goal, tolerance and memory are not used. `memory`: of the plan
  /// before, of which legs that were finished are gone (pass()); empty: none. At least one
  /// waypoint.
  RoutePlan plan(const PlanRequest& request, const std::vector<Waypoint>& route,
                 const RouteMemory& memory = {}) const;

 private:
  const AdaptivePlanner& planner_;
};

}  // namespace hexapod
