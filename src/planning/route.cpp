#include "planning/route.h"

#include <algorithm>

namespace hexapod {

void RouteMemory::begin() {
  if (steps > 0) --steps;
  if (!legs.empty()) legs.front().memory.is_begun = true;
}

void RouteMemory::pass() {
  if (!legs.empty()) legs.erase(legs.begin());
}

std::size_t RoutePlan::steps() const {
  std::size_t steps = 0;
  for (const PlanResult& leg : legs) steps += leg.steps.size();
  return steps;
}

void append(const PlanResult& leg, PlanResult& whole) {
  const bool is_first = whole.message.empty();
  if (is_first) whole.at_least_steps = leg.at_least_steps;
  whole.code =
      is_first || leg.code == PlanCode::kFound ? leg.code : whole.code;  // found, if any leg was
  whole.message += (is_first ? "" : " ") + leg.message;
  whole.steps.insert(whole.steps.end(), leg.steps.begin(), leg.steps.end());
  whole.world_from_target = leg.world_from_target;
  whole.world_from_end = leg.world_from_end;
  whole.distance_m = leg.distance_m;
  whole.heading_rad = leg.heading_rad;
  whole.length_m += leg.length_m;
  whole.duration_s += leg.duration_s;
  whole.clearance_m = std::min(whole.clearance_m, leg.clearance_m);
}

}  // namespace hexapod
