#include "tools/walk_trial.h"

#include <algorithm>
#include <cmath>

#include "common/text.h"
#include "gait/behavior.h"
#include "geometry/pose2.h"
#include "simulation/rollout.h"
#include "simulation/swept_footprint.h"
#include "tools/touch_check.h"

namespace hexapod {
namespace {

/// A simulated robot in a made world.
class Walker {
 public:
  Walker(World& world, const BehaviorOptions& behavior, const PlanTask& task)
      : world_(world),
        behavior_(behavior),
        map_from_start_(task.request.world_from_start),
        check_(*task.map) {
    world_.restart();
    // The simulation begins wherever it does; the task begins at its start.
    start_from_simulation_ = inverse(footprint(world_.worldFromBase()));
  }

  Pose2 pose() const {
    return map_from_start_ * start_from_simulation_ * footprint(world_.worldFromBase());
  }

  /// False when the robot fell, or whatever else is no walking.
  bool play(const Genome& genome) {
    const Behavior behavior(world_.robot(), genome, behavior_);
    const std::size_t steps = stepsPerCommand(behavior_.command_period_s, world_.physics().step_s);
    for (std::size_t k = 0; k < behavior.commandCount(); ++k) {
      world_.setTargets(behavior.command(k));
      for (std::size_t i = 0; i < steps; ++i) {
        if (world_.step() != Verdict::kWalked) return false;
      }
      look();
    }
    return true;
  }

  void look() {
    std::vector<double> angles_rad;
    world_.jointAngles(angles_rad);
    const std::vector<Disc> discs =
        coveredDiscs(world_.robot(), world_.worldFromBase(), angles_rad);
    clearance_m_ = std::min(clearance_m_, check_.clearance_m(pose(), discs, kLookAround_m));
  }

  double clearance_m() const { return clearance_m_; }

 private:
  World& world_;
  const BehaviorOptions& behavior_;
  Pose2 map_from_start_;
  Pose2 start_from_simulation_;
  TouchCheck check_;
  double clearance_m_ = kLookAround_m;
};

}  // namespace

WalkTrial walkThrough(World& world, const std::shared_ptr<AdaptivePlanner>& planner,
                      const BehaviorOptions& behavior, const PlanTask& task) {
  Walker walker(world, behavior, task);
  Walk walk(planner, task.request.world_from_goal, task.request.tolerance);
  walk.setObstacles(task.request.obstacles);
  WalkTrial trial;
  for (;;) {
    trial.end = walk.decide(walker.pose());
    if (trial.end.state != WalkState::kStep) break;
    const Entry& entry = planner->repertoire().entries.at(trial.end.step->entry);
    if (walker.play(entry.genome)) continue;
    trial.end.message = "fell";
    break;
  }
  trial.behaviors = walk.stepsTaken();
  trial.distance_m = distance(walker.pose(), task.request.world_from_goal);
  trial.heading_rad = headingDistance(walker.pose(), task.request.world_from_goal);
  trial.clearance_m = walker.clearance_m();
  return trial;
}

const char* const kWalkHeading =
    "| world | arrived | behaviours | distance, median / worst [cm] | heading, median / worst "
    "[degrees] | least clearance, median / worst [cm] | touched |\n|---|---|---|---|---|---|---|\n";

std::string describe(const std::string& name, const std::vector<WalkTrial>& trials) {
  std::vector<double> distances, headings, clearances;
  std::int64_t arrived = 0, behaviors = 0, touched = 0;
  for (const WalkTrial& trial : trials) {
    arrived += trial.end.state == WalkState::kArrived ? 1 : 0;
    behaviors += trial.behaviors;
    touched += trial.clearance_m < 0.0 ? 1 : 0;
    distances.push_back(100.0 * trial.distance_m);
    headings.push_back(trial.heading_rad / kDegree);
    clearances.push_back(-100.0 * trial.clearance_m);
  }
  const auto pair = [](std::vector<double> values, double sign) {
    std::sort(values.begin(), values.end());
    return fixedText(sign * values[values.size() / 2], 1) + " / " +
           fixedText(sign * values.back(), 1);
  };
  if (trials.empty()) return "";
  return "| " + name + " | " + std::to_string(arrived) + " of " + std::to_string(trials.size()) +
         " | " + std::to_string(behaviors) + " | " + pair(distances, 1.0) + " | " +
         pair(headings, 1.0) + " | " + pair(clearances, -1.0) + " | " + std::to_string(touched) +
         " |\n";
}

}  // namespace hexapod
