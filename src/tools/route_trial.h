#pragma once

#include <string>
#include <vector>

#include "common/random.h"
#include "planning/route_planner.h"
#include "tools/plan_trial.h"

namespace hexapod {

/// A route of the benchmark: the goals of some tasks in the same world, any heading, the last one's
/// as in its task, from the start of the first.
struct RouteTask {
  PlanRequest request;
  std::vector<Waypoint> route;
};

/// Routes through so many waypoints each, of tasks in their order; those that are left over where
/// the world changes belong to none.
std::vector<RouteTask> routesOf(const std::vector<PlanTask>& tasks, std::size_t waypoints);

/// One route, planned leg by leg, as a whole, and again from about where the first behaviour ends.
struct RouteTrial {
  bool planned = false;  ///< both ways
  bool whole_planned = false;
  std::size_t leg_by_leg = 0;  ///< behaviours, each leg the cheapest for itself
  std::size_t whole = 0;       ///< behaviours
  double leg_by_leg_s = 0.0;   ///< processor time
  double whole_s = 0.0;
  double again_s = 0.0;  ///< with the memory of the plan
};

RouteTrial runRoute(const AdaptivePlanner& planner, const RouteTask& task, Random& random);

/// One line of the report for routes of one kind, in the columns of kRouteHeading.
std::string describe(const std::string& name, const std::vector<RouteTrial>& trials);
extern const char* const kRouteHeading;

}  // namespace hexapod
