#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "planning/adaptive_planner.h"
#include "planning/route.h"

namespace hexapod {

/// One search for a plan through waypoints, of which each may be arrived at in several parts of its
/// tolerance: what RoutePlanner is made of. Used by one thread.
class RouteSearch {
 public:
  /// Keeps references to all three.
  RouteSearch(const AdaptivePlanner& planner, const PlanRequest& request,
              const std::vector<Waypoint>& route)
      : planner_(planner), request_(request), route_(route) {}

  /// Adds what is missing in a plan: each leg by itself, to these arrivals, with what is remembered
  /// of it.
  RoutePlan through(const std::vector<RouteMemory::Leg>& arrivals, RoutePlan plan = {}) const;

  /// The best that is found among several arrivals at each waypoint, or at the first ones where
  /// more is not to be spent; without legs when there is none. `first`: a plan through the same
  /// waypoints as they are.
  RoutePlan amongArrivals(const RoutePlan& first);

 private:
  static constexpr std::size_t kStart = static_cast<std::size_t>(-1);

  /// A beginning of the route, up to one of its waypoints.
  struct Node {
    std::size_t before = kStart;
    Waypoint arrival;
    PlanResult leg;
    std::size_t steps = 0;  ///< from the start
    double promise = 0.0;   ///< behaviours from the start to the next waypoint
  };

  bool isOver() const { return spent_ >= request_.effort || (request_.stop && request_.stop()); }

  /// Of the nodes from there on, those to go on from, the best first, of which none end alike.
  std::vector<std::size_t> best(std::size_t from) const;

  PlanResult planTo(std::size_t at, const Waypoint& arrival, const PlanMemory& memory,
                    PlanRequest request) const;

  /// The ways to a place that were looked for before.
  PlanMemory waysTo(const Waypoint& arrival) const;

  void keepWays(const Waypoint& arrival, const PlanResult& leg);

  double stepsToGo(const Pose2& from, const Waypoint& to, const WayField* ways) const;

  static const WayField* waysOf(const RoutePlan& plan, std::size_t at);

  /// In which the robot leaves a waypoint for the next one, in the world.
  double onward_rad(std::size_t at, const RoutePlan& first) const;

  /// The arrivals at a waypoint that promise most from there, the whole tolerance before them.
  std::vector<Waypoint> choose(const Pose2& from, std::size_t at, const RoutePlan& first) const;

  /// From a beginning to the waypoint after it, in several ways.
  void goOn(std::size_t beginning, std::size_t at, const RoutePlan& first);

  RoutePlan routeTo(std::size_t node) const;

  const AdaptivePlanner& planner_;
  const PlanRequest& request_;
  const std::vector<Waypoint>& route_;
  std::vector<Node> nodes_;
  std::vector<std::pair<Waypoint, PlanMemory>> known_ways_;
  double spent_ = 0.0;  ///< on other arrivals, as PlanResult::effort
};

}  // namespace hexapod
