#include "planning/route_search.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "planning/aim.h"
#include "planning/arrivals.h"
#include "planning/plan_messages.h"

namespace hexapod {
namespace {

// Beginnings of a route that are gone on from, and arrivals that are planned to from each, beside
// the whole tolerance.
constexpr std::size_t kBeginnings = 3;
constexpr std::size_t kArrivals = 3;
// Ends so near to each other make no difference.
constexpr double kAlike_m = 0.03;
// A plan that is found at once costs something, too.
constexpr double kLeastEffort = 0.001;

RouteMemory::Leg memoryOf(const PlanResult& leg, const Waypoint& arrival) {
  RouteMemory::Leg memory{arrival, leg.memory};
  memory.memory.is_begun = false;
  return memory;
}

/// Where plans to both look for the same ways.
bool isSamePlace(const Waypoint& a, const Waypoint& b) {
  return distance(a.world_from_goal, b.world_from_goal) == 0.0 &&
         a.tolerance.xy_m == b.tolerance.xy_m;
}

/// Says of a plan to a part of the tolerance what it is to the waypoint itself. What is proved of
/// the part is not of the whole.
void tellOf(const Waypoint& waypoint, PlanRequest request, PlanResult& leg) {
  request.world_from_goal = waypoint.world_from_goal;
  request.tolerance = waypoint.tolerance;
  leg.world_from_target = waypoint.world_from_goal;
  measureTo(leg.world_from_end, leg);
  leg.at_least_steps = std::min<std::size_t>(leg.at_least_steps, 1);
  leg.message = describe(leg, request, PlannerOptions{});
}

}  // namespace

RoutePlan RouteSearch::through(const std::vector<RouteMemory::Leg>& arrivals,
                               RoutePlan plan) const {
  while (plan.legs.size() < arrivals.size() && (plan.legs.empty() || plan.success())) {
    const RouteMemory::Leg& leg = arrivals[plan.legs.size()];
    PlanRequest request = request_;
    if (!plan.legs.empty()) request.world_from_start = plan.legs.back().world_from_end;
    plan.legs.push_back(planTo(plan.legs.size(), leg.arrival, leg.memory, request));
    plan.memory.legs.push_back(memoryOf(plan.legs.back(), leg.arrival));
  }
  return plan;
}

RoutePlan RouteSearch::amongArrivals(const RoutePlan& first) {
  for (std::size_t i = 0; i < first.legs.size(); ++i) keepWays(route_[i], first.legs[i]);
  std::vector<std::size_t> beginnings = {kStart};
  for (std::size_t at = 0; at < route_.size(); ++at) {
    const std::size_t from = nodes_.size();
    for (const std::size_t beginning : beginnings) goOn(beginning, at, first);
    if (isOver()) break;
    beginnings = best(from);
    if (beginnings.empty()) return {};
  }
  return routeTo(beginnings.front());
}

std::vector<std::size_t> RouteSearch::best(std::size_t from) const {
  std::vector<std::size_t> nodes(nodes_.size() - from);
  std::iota(nodes.begin(), nodes.end(), from);
  std::stable_sort(nodes.begin(), nodes.end(), [this](std::size_t a, std::size_t b) {
    return nodes_[a].promise < nodes_[b].promise;
  });
  std::vector<std::size_t> chosen;
  for (const std::size_t node : nodes) {
    const bool is_new = std::none_of(chosen.begin(), chosen.end(), [&](std::size_t other) {
      return behaviorGap_m(nodes_[node].leg.world_from_end, nodes_[other].leg.world_from_end) <
             kAlike_m;
    });
    if (is_new) chosen.push_back(node);
    if (chosen.size() == kBeginnings) break;
  }
  return chosen;
}

PlanResult RouteSearch::planTo(std::size_t at, const Waypoint& arrival, const PlanMemory& memory,
                               PlanRequest request) const {
  request.world_from_goal = arrival.world_from_goal;
  request.tolerance = arrival.tolerance;
  request.memory = memory;
  const bool is_whole =
      isSamePlace(arrival, route_[at]) && arrival.tolerance.yaw_rad == route_[at].tolerance.yaw_rad;
  if (is_whole) return planner_.plan(request);
  // What is nearest to a part of the tolerance may lie beyond the whole.
  request.goal_policy = GoalPolicy::kRefuse;
  PlanResult leg = planner_.plan(request);
  if (leg.success()) tellOf(route_[at], request, leg);
  return leg;
}

PlanMemory RouteSearch::waysTo(const Waypoint& arrival) const {
  for (const auto& [place, memory] : known_ways_) {
    if (isSamePlace(place, arrival)) return memory;
  }
  return {};
}

void RouteSearch::keepWays(const Waypoint& arrival, const PlanResult& leg) {
  if (!leg.memory.ways || waysTo(arrival).ways) return;
  PlanMemory memory;
  memory.ways = leg.memory.ways;
  memory.bound = leg.memory.bound;
  memory.is_narrow = leg.memory.is_narrow;
  known_ways_.push_back({arrival, memory});
}

double RouteSearch::stepsToGo(const Pose2& from, const Waypoint& to, const WayField* ways) const {
  return planner_.planner()->stepsToGo(from, to.world_from_goal, to.tolerance.anyHeading(), ways);
}

const WayField* RouteSearch::waysOf(const RoutePlan& plan, std::size_t at) {
  return at < plan.legs.size() ? plan.legs[at].memory.ways.get() : nullptr;
}

double RouteSearch::onward_rad(std::size_t at, const RoutePlan& first) const {
  const Pose2& here = route_[at].world_from_goal;
  const Pose2& next = route_[at + 1].world_from_goal;
  const WayField* ways = waysOf(first, at + 1);
  const auto way = ways ? ways->wayFrom(here.x_m, here.y_m) : std::nullopt;
  return way ? way->direction_rad : std::atan2(next.y_m - here.y_m, next.x_m - here.x_m);
}

std::vector<Waypoint> RouteSearch::choose(const Pose2& from, std::size_t at,
                                          const RoutePlan& first) const {
  std::vector<Waypoint> chosen = {route_[at]};
  if (at + 1 == route_.size()) return chosen;
  std::vector<std::pair<double, Waypoint>> promises;
  for (const Waypoint& arrival : arrivalsAt(route_[at], onward_rad(at, first))) {
    const double steps = stepsToGo(from, arrival, waysOf(first, at)) +
                         stepsToGo(arrival.world_from_goal, route_[at + 1], waysOf(first, at + 1));
    promises.push_back({steps, arrival});
  }
  std::stable_sort(promises.begin(), promises.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  if (promises.size() > kArrivals) promises.resize(kArrivals);
  for (const auto& [steps, arrival] : promises) chosen.push_back(arrival);
  return chosen;
}

void RouteSearch::goOn(std::size_t beginning, std::size_t at, const RoutePlan& first) {
  const Pose2 from =
      beginning == kStart ? request_.world_from_start : nodes_[beginning].leg.world_from_end;
  for (const Waypoint& arrival : choose(from, at, first)) {
    if (isOver()) return;
    PlanRequest request = request_;
    request.world_from_start = from;
    request.effort = request_.effort - spent_;
    Node node{beginning, arrival, planTo(at, arrival, waysTo(arrival), request), 0, 0.0};
    spent_ += node.leg.effort + kLeastEffort;
    if (!node.leg.success()) continue;
    keepWays(arrival, node.leg);
    node.steps = node.leg.steps.size() + (beginning == kStart ? 0 : nodes_[beginning].steps);
    node.promise = static_cast<double>(node.steps);
    if (at + 1 < route_.size()) {
      node.promise += stepsToGo(node.leg.world_from_end, route_[at + 1], waysOf(first, at + 1));
    }
    nodes_.push_back(std::move(node));
  }
}

RoutePlan RouteSearch::routeTo(std::size_t node) const {
  RoutePlan plan;
  for (; node != kStart; node = nodes_[node].before) {
    plan.legs.push_back(nodes_[node].leg);
    plan.memory.legs.push_back(memoryOf(nodes_[node].leg, nodes_[node].arrival));
  }
  std::reverse(plan.legs.begin(), plan.legs.end());
  std::reverse(plan.memory.legs.begin(), plan.memory.legs.end());
  return plan;
}

}  // namespace hexapod
