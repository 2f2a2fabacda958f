// Tells what is left of a repertoire in other worlds than the one it was learned in.
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <stdexcept>

#include "evaluation/assessment.h"
#include "repertoire/repertoire_file.h"
#include "repertoire/steadiness.h"
#include "robot/dimensions.h"
#include "robot/load_robot.h"
#include "self_model/learned_world.h"
#include "tools/command_line.h"
#include "tools/package_files.h"

namespace hexapod {
namespace {

constexpr const char* kUsage =
    "usage: assess_repertoire FILE.db [--name value ..]\n"
    "Plays the entries that a planner uses from the stand in worlds that learning did not use,\n"
    "then one after another at random in one simulation.\n";

constexpr double kDegrees = 180.0 / M_PI;

struct AssessOptions {
  std::int64_t chain = 10000;
  SteadinessOptions steadiness;
  std::int64_t seed = 1;
  std::int64_t threads = 0;
  std::string engine = "reduced";
  std::string urdf = packageFolder() + "/urdf/hexapod.urdf";
  std::string robot_config = packageFolder() + "/config/hexapod.yaml";
};

std::vector<Option> declareOptions(AssessOptions& options) {
  std::vector<Option> all = declareOptions(options.steadiness);
  const std::vector<Option> others = {
      option("chain", options.chain, "Behaviours played one after another.", 1, 10000000),
      option("seed", options.seed, "Seed of their order.", 0, 2147483647),
      option("threads", options.threads, "Threads that simulate; 0: all cores.", 0, 1024),
      option("engine", options.engine, "Simulation engine.", engineNames()),
      option("urdf", options.urdf, "Robot description."),
      option("robot_config", options.robot_config, "What the robot needs beside its URDF.")};
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

AssessOptions assessOptionsFrom(const std::vector<std::string>& words) {
  AssessOptions options;
  applyOptions(declareOptions(options), valuesFromCommandLine(words, declareOptions(options)),
               kCommandLine);
  return options;
}

void printRow(const std::string& name, const RepertoireMetrics& metrics, const std::string& rest) {
  std::printf("| %-16s | %7zu | %6.2f | %6.2f | %6.2f | %s |\n", name.c_str(), metrics.endings,
              100.0 * metrics.sparseness_m, kDegrees * metrics.median_error_in_region_rad,
              metrics.max_reach_m, rest.c_str());
}

std::string shiftText(const TrialResult& trial) {
  char text[64];
  std::snprintf(text, sizeof text, "%6.1f | %6.1f | %5lld", 1e3 * trial.median_shift_m,
                1e3 * trial.p90_shift_m, static_cast<long long>(trial.failed));
  return text;
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
  std::vector<Entry> usable;
  for (const std::size_t i : steadyEntries(repertoire.entries, options.steadiness)) {
    usable.push_back(repertoire.entries[i]);
  }
  std::printf("%s, %zu entries, %zu of them played\n\n", repertoire.run_id.c_str(),
              repertoire.entries.size(), usable.size());
  std::printf(
      "| world | entries | sparseness [cm] | median error [deg] | reach [m] | "
      "median shift [mm] | p90 [mm] | failed |\n|---|---|---|---|---|---|---|---|\n");
  printRow("as expected",
           measure(expectedEndings(usable), RegionOfInterest().scaledBy(lengthScale(robot))),
           "     - |      - |     -");
  for (const TrialResult& trial :
       resimulate(pool, learned.behavior, usable, heldOutTrials(robot, learned.physics))) {
    printRow(trial.name, trial.metrics, shiftText(trial));
  }
  // Without the return to the neutral pose there is nothing to chain.
  if (usable.empty() || learned.behavior.end_pose == EndPose::kAfterGait) return;
  const ChainResult chain = chainAtRandom(*pool, learned.behavior, usable, options.chain,
                                          static_cast<std::uint64_t>(options.seed));
  std::printf(
      "\nchained at random: %lld behaviours, %lld failed; from the expected end pose "
      "%.1f mm and %.2f deg in the median, %.1f mm and %.2f deg at p90\n",
      static_cast<long long>(chain.behaviors), static_cast<long long>(chain.failed),
      1e3 * chain.median_m, kDegrees * chain.median_rad, 1e3 * chain.p90_m,
      kDegrees * chain.p90_rad);
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') {
    std::cerr << hexapod::kUsage;
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
