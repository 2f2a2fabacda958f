#include "planning/route_planner.h"

#include <algorithm>
#include <utility>

#include "planning/route_search.h"

namespace hexapod {
namespace {

// Behaviours to a waypoint before which the arrivals are chosen again if need be.
constexpr std::size_t kNear = 2;

/// Whether another arrival at the waypoint before may help.
bool mayDependOnStart(PlanCode code) {
  return code == PlanCode::kUnreachable || code == PlanCode::kTimeout ||
         code == PlanCode::kTooManySteps;
}

/// Whether a plan through the arrivals of a memory has as few behaviours as that promised. One more
/// is let pass where the next waypoint is far: what is lost on the way may be gained again.
bool isAsPromised(const RoutePlan& plan, const RouteMemory& memory) {
  const std::size_t more = plan.legs.front().steps.size() > kNear ? 1 : 0;
  return plan.success() && plan.steps() <= memory.steps + more;
}

bool isBetter(const RoutePlan& plan, const RoutePlan& than) {
  if (plan.success() != than.success()) return plan.success();
  if (plan.legs.size() != than.legs.size()) return plan.legs.size() > than.legs.size();
  return plan.steps() < than.steps();
}

std::vector<RouteMemory::Leg> asGiven(const std::vector<Waypoint>& route) {
  std::vector<RouteMemory::Leg> legs;
  for (const Waypoint& waypoint : route) legs.push_back({waypoint, {}});
  return legs;
}

}  // namespace

RoutePlan RoutePlanner::plan(const PlanRequest& request, const std::vector<Waypoint>& route,
                             const RouteMemory& memory) const {
  RouteSearch search(planner_, request, route);
  const std::vector<RouteMemory::Leg> as_given = asGiven(route);
  RoutePlan best;
  if (!memory.legs.empty()) {
    std::vector<RouteMemory::Leg> legs = memory.legs;
    legs.insert(legs.end(), as_given.begin() + static_cast<std::ptrdiff_t>(legs.size()),
                as_given.end());
    best = search.through(legs);
    const bool is_whole = memory.legs.size() == route.size();
    if (route.size() == 1 || (is_whole && isAsPromised(best, memory))) {
      best.memory.steps = std::min(best.steps(), memory.steps);
      return best;
    }
  }
  const RoutePlan first = search.through(as_given);
  if (best.legs.empty() || isBetter(first, best)) best = first;
  if (route.size() > 1 && (first.success() || mayDependOnStart(first.legs.back().code))) {
    RoutePlan found = search.amongArrivals(first);
    if (!found.legs.empty()) found = search.through(as_given, std::move(found));
    if (!found.legs.empty() && isBetter(found, best)) best = std::move(found);
  }
  // From the same start to the same waypoint.
  std::size_t& at_least = best.legs.front().at_least_steps;
  at_least = std::max(at_least, first.legs.front().at_least_steps);
  best.memory.steps = best.steps();
  return best;
}

}  // namespace hexapod
