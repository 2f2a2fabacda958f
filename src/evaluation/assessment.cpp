#include "evaluation/assessment.h"

#include <optional>

#include "common/text.h"
#include "evaluation/chains.h"
#include "geometry/arc.h"
#include "robot/dimensions.h"
#include "simulation/rollout.h"

namespace hexapod {
namespace {

TrialResult resultOf(const std::string& name, const RegionOfInterest& region,
                     const std::vector<Entry>& entries, const BatchResult* results) {
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
                                    const std::vector<Trial>& trials, const PlayHooks& hooks) {
  std::vector<Physics> physics;
  for (const Trial& trial : trials) physics.push_back(trial.physics);
  std::vector<Genome> genomes;
  for (const Entry& entry : entries) genomes.push_back(entry.genome);
  std::vector<RobustWorlds::Run> runs;
  for (std::size_t p = 0; p < trials.size(); ++p) {
    for (std::size_t i = 0; i < entries.size(); ++i) runs.push_back({i, p, nullptr});
  }
  const auto played = RobustWorlds(pool, physics, behavior).play(genomes, runs, hooks);
  const RegionOfInterest region = RegionOfInterest().scaledBy(lengthScale(pool->robot()));
  std::vector<TrialResult> results;
  for (std::size_t p = 0; p < trials.size(); ++p) {
    const BatchResult* first = played.data() + p * entries.size();
    results.push_back(resultOf(trials[p].name, region, entries, first));
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

}  // namespace hexapod
