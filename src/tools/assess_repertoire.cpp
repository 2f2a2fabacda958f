// Tells what is left of a repertoire in other worlds than the one it was learned in.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <stdexcept>

#include "common/options_help.h"
#include "evaluation/assessment.h"
#include "evaluation/chains.h"
#include "evaluation/test_set.h"
#include "geometry/pose2.h"
#include "repertoire/repertoire_file.h"
#include "repertoire/steadiness.h"
#include "robot/dimensions.h"
#include "robot/load_robot.h"
#include "self_model/learned_world.h"
#include "simulation/body_text.h"
#include "tools/command_line.h"
#include "tools/package_files.h"

namespace hexapod {
namespace {

constexpr const char* kUsage =
    "usage: assess_repertoire FILE.db [--name value ...]\n\n"
    "Plays the entries that a planner uses one after another at random, in the world they were\n"
    "learned in and in the 20 worlds of the test set, then each from the stand in worlds in which\n"
    "one thing differs.\n";

struct AssessOptions {
  std::int64_t chain = 10000;
  std::int64_t test_chain = 500;
  SteadinessOptions steadiness;
  std::int64_t seed = 1;
  std::int64_t threads = 0;
  std::string body;
  std::string engine = "reduced";
  std::string urdf = packageFolder() + "/urdf/hexapod.urdf";
  std::string robot_config = packageFolder() + "/config/hexapod.yaml";
};

std::vector<Option> declareOptions(AssessOptions& options) {
  std::vector<Option> all = declareOptions(options.steadiness);
  const std::vector<Option> others = {
      option("chain", options.chain, "Behaviours played one after another where they were learned.",
             1, 10000000),
      option("test_chain", options.test_chain,
             "Behaviours played one after another in each world of the test set; 0: none.", 0,
             10000000),
      option("seed", options.seed, "Seed of their order.", 0, 2147483647),
      option("threads", options.threads, "Threads that simulate; 0: all cores.", 0, 1024),
      option("body", options.body,
             "Also play each from the stand with this body, as in 'friction: 0.6, gain: 0.7'; "
             "empty: none."),
      option("engine", options.engine, "Simulation engine.", engineNames()),
      option("urdf", options.urdf, "Robot description."),
      option("robot_config", options.robot_config, "What the robot needs beside its URDF.")};
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

std::string usage() {
  AssessOptions options;
  return helpOn(kUsage, declareOptions(options));
}

AssessOptions assessOptionsFrom(const std::vector<std::string>& words) {
  AssessOptions options;
  applyOptions(declareOptions(options), valuesFromCommandLine(words, declareOptions(options)),
               kCommandLine);
  return options;
}

void printRow(const std::string& name, const RepertoireMetrics& metrics, const std::string& rest) {
  std::printf("| %-16s | %7zu | %6.2f | %6.2f | %6.2f | %s |\n", name.c_str(), metrics.endings,
              100.0 * metrics.sparseness_m, metrics.median_error_in_region_rad / kDegree,
              metrics.max_reach_m, rest.c_str());
}

std::string shiftText(const TrialResult& trial) {
  char text[64];
  std::snprintf(text, sizeof text, "%6.1f | %6.1f | %5lld", 1e3 * trial.median_shift_m,
                1e3 * trial.p90_shift_m, static_cast<long long>(trial.failed));
  return text;
}

/// "12.3 | 25.0 | 1.02 | 4.10 | 500 | 0": median and p90 of the misses [mm, degrees], behaviours
/// and failures.
std::string missText(const ChainResult& chain) {
  char text[128];
  std::snprintf(text, sizeof text, "%6.1f | %6.1f | %6.2f | %6.2f | %6lld | %3lld",
                1e3 * quantile(chain.misses_m, 0.5), 1e3 * quantile(chain.misses_m, 0.9),
                quantile(chain.misses_rad, 0.5) / kDegree,
                quantile(chain.misses_rad, 0.9) / kDegree,
                static_cast<long long>(chain.behaviors()), static_cast<long long>(chain.failed));
  return text;
}

/// What a world differs in, as in "mu 0.71 gain 1.20 mass 0.97 torque 0.85 slope 1.2 -0.4 deg 22 ms
/// step 3.0 ms".
std::string describe(const Physics& world) {
  char text[160];
  std::snprintf(
      text, sizeof text,
      "friction %.2f, gain %.2f, mass %.2f, torque %.2f, slopes %4.1f %4.1f deg, %2.0f ms "
      "late, step %.1f ms",
      world.friction_scale, world.servo_gain_scale, world.mass_scale, world.torque_scale,
      world.slope_x_rad / kDegree, world.slope_y_rad / kDegree, 1e3 * world.command_latency_s,
      1e3 * world.step_s);
  return text;
}

/// So many behaviours in each world, in up to kChains simulations at a time.
std::vector<ChainResult> chains(const std::shared_ptr<WorldPool>& pool,
                                const BehaviorOptions& behavior, const std::vector<Entry>& entries,
                                const std::vector<Physics>& worlds, std::int64_t behaviors,
                                std::int64_t seed) {
  constexpr std::int64_t kChains = 10;
  ChainOptions options;
  options.chains = std::min(kChains, behaviors);
  options.behaviors = behaviors / options.chains;
  options.seed = static_cast<std::uint64_t>(seed);
  return chainAtRandom(pool, behavior, entries, worlds, options);
}

void printChains(const std::shared_ptr<WorldPool>& pool, const BehaviorOptions& behavior,
                 const std::vector<Entry>& entries, const AssessOptions& options) {
  std::printf(
      "One after another at random, from the expected end pose:\n\n| world | median [mm] | p90 "
      "[mm] | median [deg] | p90 [deg] | behaviours | failed |\n|---|---|---|---|---|---|---|\n");
  const Physics& own = pool->physics();
  const ChainResult learned =
      chains(pool, behavior, entries, {own}, options.chain, options.seed).front();
  std::printf("| as learned | %s |\n", missText(learned).c_str());
  if (options.test_chain == 0) return;
  const std::vector<Physics> worlds = testSet(own, behavior.command_period_s);
  const std::vector<ChainResult> results =
      chains(pool, behavior, entries, worlds, options.test_chain, options.seed);
  ChainResult all;
  for (const ChainResult& result : results) all.add(result);
  std::printf("| test set | %s |\n", missText(all).c_str());
  for (std::size_t i = 0; i < worlds.size(); ++i) {
    std::printf("| %zu: %s | %s |\n", i + 1, describe(worlds[i]).c_str(),
                missText(results[i]).c_str());
  }
}

void printWorlds(const std::shared_ptr<WorldPool>& pool, const BehaviorOptions& behavior,
                 const std::vector<Entry>& entries, const std::string& body) {
  std::printf(
      "\nEach from the stand:\n\n| world | entries | sparseness [cm] | median error [deg] | reach "
      "[m] | median shift [mm] | p90 [mm] | failed |\n|---|---|---|---|---|---|---|---|\n");
  const RobotDescription& robot = pool->robot();
  printRow("as expected",
           measure(expectedEndings(entries), RegionOfInterest().scaledBy(lengthScale(robot))),
           "     - |      - |     -");
  std::vector<Trial> trials = heldOutTrials(robot, pool->physics());
  if (!body.empty()) trials.push_back({body, bodyFromText(robot, body, pool->physics())});
  for (const TrialResult& trial : resimulate(pool, behavior, entries, trials)) {
    printRow(trial.name, trial.metrics, shiftText(trial));
  }
}

void assess(const Repertoire& repertoire, const AssessOptions& options) {
  const RobotDescription robot = loadRobot(options.urdf, options.robot_config);
  if (robot.digest != repertoire.robot_id) {
    throw std::runtime_error("The repertoire was learned for another robot (" +
                             repertoire.robot_id + ") than that of " + options.urdf + " (" +
                             robot.digest + "); name its files with --urdf and --robot_config.");
  }
  const LearnedWorld learned = learnedWorldOf(robot, repertoire);
  const EngineChoice engine = chooseEngine(options.engine, robot);
  const auto pool = std::make_shared<WorldPool>(engine.engine, robot, learned.physics,
                                                static_cast<int>(options.threads));
  const std::vector<Entry> usable = onlySteady(repertoire.entries, options.steadiness);
  std::printf("%s, %zu entries, %zu of them played\n\n", repertoire.run_id.c_str(),
              repertoire.entries.size(), usable.size());
  // Without the return to the neutral pose there is nothing to chain.
  const bool chained = !usable.empty() && learned.behavior.end_pose != EndPose::kAfterGait;
  if (chained) printChains(pool, learned.behavior, usable, options);
  printWorlds(pool, learned.behavior, usable, options.body);
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') {
    std::cerr << hexapod::usage();
    return 2;
  }
  try {
    hexapod::assess(hexapod::loadRepertoire(argv[1]),
                    hexapod::assessOptionsFrom({argv + 2, argv + argc}));
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return 0;
}
