#include "evaluation/assessment.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

#include "common/random.h"
#include "common/text.h"
#include "evaluation/robust_worlds.h"
#include "geometry/arc.h"
#include "robot/dimensions.h"
#include "simulation/rollout.h"

namespace hexapod {
namespace {

/// The value that `share` of all do not exceed; 0 without values.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto last = static_cast<double>(values.size() - 1);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::lround(share * last));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

TrialResult resultOf(const std::string& name, const RegionOfInterest& region,
                     const std::vector<Entry>& entries, const std::vector<BatchResult>& results) {
  TrialResult trial;
  trial.name = name;
  std::vector<Ending> endings;
  std::vector<double> shifts_m;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Outcome& outcome = results[i].outcome;
    if (!outcome.walked()) {
      ++trial.failed;
      continue;
    }
    endings.push_back({outcome.end_pose, orientationError(outcome.end_pose)});
    shifts_m.push_back(distance(outcome.end_pose, entries[i].expectedPose()));
  }
  trial.metrics = measure(endings, region);
  trial.median_shift_m = quantile(shifts_m, 0.5);
  trial.p90_shift_m = quantile(shifts_m, 0.9);
  return trial;
}

}  // namespace

std::vector<Trial> heldOutTrials(const RobotDescription& robot, const Physics& nominal) {
  std::vector<Trial> trials = {{"nominal", nominal}};
  const auto add = [&](const std::string& name, double Physics::*value, double factor) {
    trials.push_back({name, nominal});
    trials.back().physics.*value *= factor;
  };
  trials.push_back({"5 ms step", nominal});
  trials.back().physics.step_s = 0.005;
  add("mu 0.7", &Physics::friction_scale, 0.7 / robot.contact.friction);
  add("mu 1.1", &Physics::friction_scale, 1.1 / robot.contact.friction);
  add("mass -10 %", &Physics::mass_scale, 0.9);
  add("mass +10 %", &Physics::mass_scale, 1.1);
  add("servo gain -20 %", &Physics::servo_gain_scale, 0.8);
  add("servo gain +20 %", &Physics::servo_gain_scale, 1.2);
  add("torque -20 %", &Physics::torque_scale, 0.8);
  return trials;
}

std::vector<TrialResult> resimulate(const std::shared_ptr<WorldPool>& pool,
                                    const BehaviorOptions& behavior,
                                    const std::vector<Entry>& entries,
                                    const std::vector<Trial>& trials,
                                    const std::atomic<bool>* cancelled) {
  std::vector<Physics> physics;
  for (const Trial& trial : trials) physics.push_back(trial.physics);
  RobustWorlds worlds(pool, physics, behavior.command_period_s);
  std::deque<Behavior> behaviors;
  for (const Entry& entry : entries) behaviors.emplace_back(pool->robot(), entry.genome, behavior);
  std::vector<TrialResult> results;
  const RegionOfInterest region = RegionOfInterest().scaledBy(lengthScale(pool->robot()));
  for (std::size_t p = 0; p < trials.size(); ++p) {
    std::vector<RobustWorlds::Run> runs;
    for (const Behavior& one : behaviors) runs.push_back({p, &one, nullptr});
    results.push_back(resultOf(trials[p].name, region, entries, worlds.play(runs, cancelled)));
  }
  return results;
}

HeldOut heldOutMedians(const std::vector<TrialResult>& results) {
  std::vector<double> sparseness_m, error_rad, shift_m;
  for (std::size_t i = 1; i < results.size(); ++i) {
    sparseness_m.push_back(results[i].metrics.sparseness_m);
    error_rad.push_back(results[i].metrics.median_error_in_region_rad);
    shift_m.push_back(results[i].median_shift_m);
  }
  return {median(sparseness_m).value_or(0.0), median(error_rad).value_or(0.0),
          median(shift_m).value_or(0.0)};
}

std::map<std::string, std::string> factsOf(const std::vector<TrialResult>& results) {
  std::map<std::string, std::string> facts;
  for (const TrialResult& result : results) {
    const std::string prefix = "resimulated." + result.name + ".";
    facts[prefix + "sparseness_m"] = exactText(result.metrics.sparseness_m);
    facts[prefix + "median_orientation_error_rad"] =
        exactText(result.metrics.median_error_in_region_rad);
    facts[prefix + "median_shift_m"] = exactText(result.median_shift_m);
    facts[prefix + "failed"] = std::to_string(result.failed);
  }
  return facts;
}

ChainResult chainAtRandom(const WorldPool& pool, const BehaviorOptions& behavior,
                          const std::vector<Entry>& entries, std::int64_t behaviors,
                          std::uint64_t seed) {
  const std::unique_ptr<World> world = makeWorld(pool.engine(), pool.robot(), pool.physics());
  world->restart();
  Random random(seed);
  ChainResult result;
  std::vector<double> distances_m;
  std::vector<double> angles_rad;
  for (; result.behaviors < behaviors; ++result.behaviors) {
    const Entry& entry = entries[random.below(entries.size())];
    const Behavior next(pool.robot(), entry.genome, behavior);
    const Outcome outcome = play(*world, next, behavior.command_period_s);
    if (!outcome.walked()) {
      ++result.failed;
      world->restart();
      continue;
    }
    distances_m.push_back(distance(outcome.end_pose, entry.expectedPose()));
    angles_rad.push_back(headingDistance(outcome.end_pose, entry.expectedPose()));
  }
  result.median_m = quantile(distances_m, 0.5);
  result.p90_m = quantile(distances_m, 0.9);
  result.median_rad = quantile(angles_rad, 0.5);
  result.p90_rad = quantile(angles_rad, 0.9);
  return result;
}

}  // namespace hexapod
