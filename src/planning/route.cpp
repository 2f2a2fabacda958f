#include "planning/route.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace hexapod {
namespace {

// Either side of the direction that one arrives in.
constexpr double kFacing_rad = M_PI / 6.0;
constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();

PlanRequest requestFor(const PlanRequest& request, const Waypoint& waypoint) {
  PlanRequest leg = request;
  leg.world_from_goal = waypoint.world_from_goal;
  leg.tolerance = waypoint.tolerance;
  return leg;
}

/// The same waypoint, to be arrived at in about that heading; nothing where it may not be.
std::optional<Waypoint> facing(const Waypoint& waypoint, double heading_rad) {
  Waypoint faced = waypoint;
  faced.world_from_goal.yaw_rad = heading_rad;
  faced.tolerance.yaw_rad = kFacing_rad;
  if (waypoint.tolerance.anyHeading()) return faced;
  const double off_rad = headingDistance(faced.world_from_goal, waypoint.world_from_goal);
  if (off_rad + kFacing_rad > waypoint.tolerance.yaw_rad) return std::nullopt;
  return faced;
}

/// Behaviours of a leg and of the one after it.
std::size_t stepsOfBoth(const PlanFunction& plan, const PlanRequest& request, const PlanResult& leg,
                        const Waypoint& next) {
  if (!leg.success()) return kNever;
  PlanRequest after = requestFor(request, next);
  after.world_from_start = leg.world_from_end;
  after.memory = {};
  const PlanResult second = plan(after);
  return second.success() ? leg.steps.size() + second.steps.size() : kNever;
}

}  // namespace

PlanResult planLeg(const PlanFunction& plan, const PlanRequest& request, const Waypoint& waypoint,
                   const Waypoint* next) {
  PlanResult best = plan(requestFor(request, waypoint));
  if (!next || best.code != PlanCode::kFound) return best;
  const Pose2& here = waypoint.world_from_goal;
  const double ahead_rad =
      std::atan2(next->world_from_goal.y_m - here.y_m, next->world_from_goal.x_m - here.x_m);
  std::optional<std::size_t> least;
  for (const double heading_rad : {ahead_rad, wrapAngle(ahead_rad + M_PI)}) {
    const auto faced = facing(waypoint, heading_rad);
    if (!faced) continue;
    if (!least) least = stepsOfBoth(plan, request, best, *next);
    PlanResult leg = plan(requestFor(request, *faced));
    const std::size_t steps = stepsOfBoth(plan, request, leg, *next);
    if (steps >= *least) continue;
    least = steps;
    best = std::move(leg);
  }
  return best;
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
