#include "tools/plan_trial.h"

#include <algorithm>
#include <cmath>

#include "common/text.h"
#include "tools/bench_numbers.h"
#include "tools/machine.h"
#include "tools/touch_check.h"

namespace hexapod {
namespace {

constexpr std::size_t kWorlds = 10;
// How a behaviour may miss its prediction before the next plan.
constexpr double kMiss_m = 0.004;
constexpr double kMiss_rad = 0.008;

double normal(Random& random) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - random.uniform()));
  return radius * std::cos(2.0 * M_PI * random.uniform());
}

/// Draws poses in the middle of cells.
class PoseDraw {
 public:
  PoseDraw(const OccupancyMap& map, Random& random) : map_(map), random_(random) {}

  std::size_t cell() { return static_cast<std::size_t>(random_.below(map_.cells.size())); }
  Pose2 poseIn(std::size_t cell) {
    const auto columns = static_cast<std::size_t>(map_.columns);
    const std::size_t row = cell / columns;
    const double x = (static_cast<double>(cell % columns) + 0.5) * map_.resolution_m;
    const double y = (static_cast<double>(row) + 0.5) * map_.resolution_m;
    return map_.world_from_map * Pose2{x, y, random_.uniform(-M_PI, M_PI)};
  }

 private:
  const OccupancyMap& map_;
  Random& random_;
};

/// "0.03 | 20.9": the median of planning again [ms], and planning afresh over that, in the mean.
std::string replanText(const std::vector<PlanTrial>& trials, Replan PlanTrial::*which) {
  std::vector<double> again, afresh;
  for (const PlanTrial& trial : trials) {
    const Replan& replan = trial.*which;
    if (!replan.succeeded) continue;
    again.push_back(1e3 * replan.again_s);
    afresh.push_back(1e3 * replan.afresh_s);
  }
  return fixedText(quantile(again, 0.5), 2) + " | " +
         fixedText(mean(afresh) / std::max(1e-9, mean(again)), 1);
}

}  // namespace

std::vector<PlanTask> tasksInTheEmpty(std::size_t count, const GoalTolerance& tolerance,
                                      std::uint64_t seed) {
  Random random(seed);
  std::vector<PlanTask> tasks(count);
  for (PlanTask& task : tasks) {
    task.request.world_from_goal = {random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0),
                                    random.uniform(-M_PI, M_PI)};
    task.request.tolerance = tolerance;
  }
  return tasks;
}

std::vector<PlanTask> tasksIn(const WorldKind& kind, std::size_t count,
                              const GoalTolerance& tolerance, const Footprint& footprint,
                              const ObstacleOptions& options, std::uint64_t seed) {
  Random random(seed);
  std::vector<PlanTask> tasks;
  const double radius_m = footprint.outer_m() + options.footprint_margin_m;
  const bool closed = kind.layout == WorldKind::Layout::kClosedRooms;
  for (std::size_t w = 0; w < kWorlds; ++w) {
    const auto map = std::make_shared<const OccupancyMap>(makeWorldOf(kind, random.bits()));
    const auto obstacles = std::make_shared<const Obstacles>(*map, footprint, options);
    PoseDraw draw(*map, random);
    while (tasks.size() < count * (w + 1) / kWorlds) {
      const std::size_t start = draw.cell();
      const auto columns = static_cast<std::size_t>(map->columns);
      const std::vector<char> connected = connectedCells(
          *map, radius_m, static_cast<int>(start % columns), static_cast<int>(start / columns));
      if (!connected[start]) continue;
      const std::size_t goal = draw.cell();
      const std::vector<char> around = connectedCells(
          *map, radius_m, static_cast<int>(goal % columns), static_cast<int>(goal / columns));
      if (!around[goal] || (connected[goal] != 0) == closed) continue;
      PlanTask task;
      task.map = map;
      task.request.world_from_start = draw.poseIn(start);
      task.request.world_from_goal = draw.poseIn(goal);
      task.request.tolerance = tolerance;
      task.request.obstacles = obstacles;
      tasks.push_back(task);
    }
  }
  return tasks;
}

bool isConnected(const PlanTask& task, double radius_m) {
  const OccupancyMap& map = *task.map;
  const auto cellOf = [&map](const Pose2& world) {
    const Pose2 at = inverse(map.world_from_map) * world;
    return std::make_pair(static_cast<int>(at.x_m / map.resolution_m),
                          static_cast<int>(at.y_m / map.resolution_m));
  };
  const auto [column, row] = cellOf(task.request.world_from_start);
  const auto [goal_column, goal_row] = cellOf(task.request.world_from_goal);
  const std::size_t goal =
      static_cast<std::size_t>(goal_row) * static_cast<std::size_t>(map.columns) +
      static_cast<std::size_t>(goal_column);
  return connectedCells(map, radius_m, column, row)[goal] != 0;
}

Pose2 drawMiss(Random& random) {
  return {kMiss_m * normal(random), kMiss_m * normal(random), kMiss_rad * normal(random)};
}

PlanTrial PlanTrials::run(const PlanTask& task, Random& random) const {
  PlanTrial trial;
  PlanRequest request = task.request;
  double begin_s = 0.0;
  bool first = true;
  request.improved = [&](std::size_t) {
    if (first) trial.first_s = threadCpu_s() - begin_s;
    first = false;
  };
  begin_s = threadCpu_s();
  trial.plan = planner_.plan(request);
  trial.whole_s = threadCpu_s() - begin_s;
  trial.touch_m = clearance_m(task, trial.plan);
  if (trial.plan.steps.size() < 2) return trial;
  trial.predicted = planAgain(task, trial.plan, Pose2());
  trial.missed = planAgain(task, trial.plan, drawMiss(random));
  return trial;
}

Replan PlanTrials::planAgain(const PlanTask& task, const PlanResult& plan,
                             const Pose2& miss) const {
  Replan replan;
  PlanRequest request = task.request;
  request.world_from_start = plan.steps.front().world_from_end * miss;
  double begin_s = threadCpu_s();
  const bool afresh = planner_.plan(request).success();
  replan.afresh_s = threadCpu_s() - begin_s;
  request.memory = plan.memory;
  begin_s = threadCpu_s();
  const bool again = planner_.plan(request).success();
  replan.again_s = threadCpu_s() - begin_s;
  replan.succeeded = afresh && again;
  return replan;
}

/// Along the simulated path of every behaviour, bent evenly to where it is expected to end.
double PlanTrials::clearance_m(const PlanTask& task, const PlanResult& plan) const {
  if (!task.map) return kLookAround_m;
  const TouchCheck check(*task.map);
  double least_m = kLookAround_m;
  Pose2 from = task.request.world_from_start;
  for (const PlannedStep& step : plan.steps) {
    const std::vector<Pose2>& way = paths_.at(step.entry);
    const Pose2 end = repertoire_.entries.at(step.entry).expectedPose();
    std::vector<Pose2> poses = {from};
    for (std::size_t i = 0; i < way.size(); ++i) {
      const double share = static_cast<double>(i + 1) / static_cast<double>(way.size());
      poses.push_back(from *
                      Pose2{way[i].x_m + share * (end.x_m - way.back().x_m),
                            way[i].y_m + share * (end.y_m - way.back().y_m),
                            way[i].yaw_rad + share * wrapAngle(end.yaw_rad - way.back().yaw_rad)});
    }
    least_m = std::min(least_m, check.clearanceAlong_m(poses, footprint_.discs, kLookAround_m));
    from = step.world_from_end;
  }
  return least_m;
}

const char* const kPlanHeading =
    "| world | planned | first plan, median / p95 [ms] | whole, median / p99 / max [ms] | "
    "behaviours "
    "| proved "
    "fewest | behaviours / bound | again as predicted, median [ms] | afresh / again | again after "
    "a "
    "miss, median [ms] | afresh / again | touched | least room beside the footprint [cm] "
    "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";

std::string describe(const std::string& name, const std::vector<PlanTrial>& trials) {
  std::vector<double> first, whole, steps, bounds;
  std::size_t found = 0, proved = 0, touched = 0;
  double room_m = kLookAround_m;
  for (const PlanTrial& trial : trials) {
    whole.push_back(1e3 * trial.whole_s);
    if (!trial.plan.success()) continue;
    ++found;
    first.push_back(1e3 * trial.first_s);
    steps.push_back(static_cast<double>(trial.plan.steps.size()));
    bounds.push_back(static_cast<double>(trial.plan.at_least_steps));
    proved += trial.plan.gap() == 0 ? 1 : 0;
    touched += trial.touch_m < 0.0 ? 1 : 0;
    room_m = std::min(room_m, trial.touch_m);
  }
  return tableRow(
      {name, std::to_string(found) + " of " + std::to_string(trials.size()),
       fixedText(quantile(first, 0.5), 1) + " / " + fixedText(quantile(first, 0.95), 1),
       fixedText(quantile(whole, 0.5), 1) + " / " + fixedText(quantile(whole, 0.99), 1) + " / " +
           fixedText(quantile(whole, 1.0), 1),
       fixedText(mean(steps), 2), std::to_string(proved),
       fixedText(mean(steps) / std::max(1.0, mean(bounds)), 2),
       replanText(trials, &PlanTrial::predicted), replanText(trials, &PlanTrial::missed),
       std::to_string(touched), fixedText(100.0 * room_m, 1)});
}

}  // namespace hexapod
