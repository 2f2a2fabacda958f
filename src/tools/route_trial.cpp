#include "tools/route_trial.h"

#include <algorithm>
#include <string>

#include "common/text.h"
#include "tools/bench_numbers.h"
#include "tools/machine.h"

namespace hexapod {
namespace {

const GoalTolerance kPassing{0.05, -1.0};

/// Each leg from where the one before ends; 0 where one has no plan.
std::size_t stepsLegByLeg(const AdaptivePlanner& planner, const RouteTask& task) {
  std::size_t steps = 0;
  PlanRequest request = task.request;
  for (const Waypoint& waypoint : task.route) {
    request.world_from_goal = waypoint.world_from_goal;
    request.tolerance = waypoint.tolerance;
    const PlanResult leg = planner.plan(request);
    if (!leg.success()) return 0;
    steps += leg.steps.size();
    request.world_from_start = leg.world_from_end;
  }
  return steps;
}

}  // namespace

std::vector<RouteTask> routesOf(const std::vector<PlanTask>& tasks, std::size_t waypoints) {
  std::vector<RouteTask> routes;
  RouteTask route;
  for (const PlanTask& task : tasks) {
    if (route.route.empty() || route.request.obstacles != task.request.obstacles) {
      route = {task.request, {}};
    }
    route.route.push_back({task.request.world_from_goal, kPassing});
    if (route.route.size() < waypoints) continue;
    route.route.back().tolerance = task.request.tolerance;
    routes.push_back(std::move(route));
    route = {};
  }
  return routes;
}

RouteTrial runRoute(const AdaptivePlanner& planner, const RouteTask& task, Random& random) {
  RouteTrial trial;
  double begin_s = threadCpu_s();
  trial.leg_by_leg = stepsLegByLeg(planner, task);
  trial.leg_by_leg_s = threadCpu_s() - begin_s;
  begin_s = threadCpu_s();
  RoutePlan plan = RoutePlanner(planner).plan(task.request, task.route);
  trial.whole_s = threadCpu_s() - begin_s;
  trial.whole_planned = plan.success();
  trial.planned = plan.success() && trial.leg_by_leg > 0;
  trial.whole = plan.steps();
  if (!plan.success() || plan.legs.front().steps.empty()) return trial;
  PlanRequest request = task.request;
  request.world_from_start = plan.legs.front().steps.front().world_from_end * drawMiss(random);
  plan.memory.begin();
  begin_s = threadCpu_s();
  RoutePlanner(planner).plan(request, task.route, plan.memory);
  trial.again_s = threadCpu_s() - begin_s;
  return trial;
}

const char* const kRouteHeading =
    "| routes | planned leg by leg / whole | behaviours leg by leg | whole | fewer [%] | leg by "
    "leg, median [ms] | whole, median / p99 [ms] | again, median / p99 [ms] "
    "|\n|---|---|---|---|---|---|---|---|\n";

std::string describe(const std::string& name, const std::vector<RouteTrial>& trials) {
  std::vector<double> legs, wholes, legs_ms, wholes_ms, again_ms;
  std::size_t planned_legs = 0, planned_wholes = 0;
  for (const RouteTrial& trial : trials) {
    planned_legs += trial.leg_by_leg > 0 ? 1 : 0;
    planned_wholes += trial.whole_planned ? 1 : 0;
    if (!trial.planned) continue;
    legs.push_back(static_cast<double>(trial.leg_by_leg));
    wholes.push_back(static_cast<double>(trial.whole));
    legs_ms.push_back(1e3 * trial.leg_by_leg_s);
    wholes_ms.push_back(1e3 * trial.whole_s);
    again_ms.push_back(1e3 * trial.again_s);
  }
  const double saved = 1.0 - mean(wholes) / std::max(1e-9, mean(legs));
  const auto medianAndTail = [](const std::vector<double>& values) {
    return fixedText(quantile(values, 0.5), 1) + " / " + fixedText(quantile(values, 0.99), 1);
  };
  return tableRow({name,
                   std::to_string(planned_legs) + " / " + std::to_string(planned_wholes) + " of " +
                       std::to_string(trials.size()),
                   fixedText(mean(legs), 2), fixedText(mean(wholes), 2),
                   fixedText(100.0 * saved, 1), fixedText(quantile(legs_ms, 0.5), 1),
                   medianAndTail(wholes_ms), medianAndTail(again_ms)});
}

}  // namespace hexapod
