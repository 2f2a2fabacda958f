// Finds by how much a robot is otherwise than its files say, from what its behaviours do.
#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>
#include <set>
#include <stdexcept>

#include "calibration/calibrated_robot.h"
#include "calibration/choose_behaviors.h"
#include "common/options_help.h"
#include "repertoire/repertoire_file.h"
#include "repertoire/steadiness.h"
#include "robot/load_robot.h"
#include "simulation/body_text.h"
#include "tools/calibration_draws.h"
#include "tools/command_line.h"
#include "tools/package_files.h"
#include "tools/text_file.h"

namespace hexapod {
namespace {

struct CalibrateOptions {
  std::string file;
  std::string output = "calibrated";
  std::string simulated;
  std::int64_t draws = 0;
  std::int64_t learn = 0;
  std::string plan;
  std::string trials;
  std::int64_t behaviors = 20;
  std::int64_t checks = 10;
  std::int64_t seed = 1;
  std::int64_t threads = 0;
  PoseNoise noise;
  std::string engine = "reduced";
  std::string urdf = packageFolder() + "/urdf/hexapod.urdf";
  std::string robot_config = packageFolder() + "/config/hexapod.yaml";
  FitOptions fit;
  bool help = false;
};

std::vector<Option> declareOptions(CalibrateOptions& options) {
  return {
      option("file", options.file, "Repertoire whose entries are played."),
      option("output", options.output,
             "Where the robot's new YAML (.yaml), the report (.md), the trials (.csv) and the "
             "picture (.png) go, without the endings."),
      option("simulated", options.simulated,
             "Play with a simulated robot that has this body, as in 'friction: 0.8, gain: 0.9'."),
      option("draws", options.draws,
             "Calibrate so many simulated robots, drawn at random within 30 %, and print a table; "
             "nothing is written.",
             0, 100000),
      option("learn", options.learn,
             "With draws: also learn so many candidates with what was found of each, and play the "
             "entries one after another in its world; 0: none.",
             0, 100000000),
      option("plan", options.plan,
             "Write the behaviours to play to this file, and end: a robot's own programs play "
             "them."),
      option("trials", options.trials, "Fit to the trials of this file, played before."),
      option("behaviors", options.behaviors, "Behaviours that are played to be fitted to.", 1,
             1000),
      option("checks", options.checks,
             "Behaviours that are played after them, drawn at random, to see how well those that "
             "were not fitted are predicted.",
             0, 1000),
      option("seed", options.seed, "Seed of everything random.", 0, 2147483647),
      option("threads", options.threads, "Threads that simulate; 0: all cores.", 0, 1024),
      option("measurement_noise_m", options.noise.position_m, "m",
             "Standard deviation of measured positions, per axis.", 0.0, 1.0),
      option("measurement_noise_rad", options.noise.heading_rad, "rad",
             "Standard deviation of measured headings.", 0.0, 1.0),
      option("model_noise_m", options.fit.noise_m, "m",
             "What simulation with the right body misses of an end position, per axis.", 1e-5, 1.0),
      option("model_noise_rad", options.fit.noise_rad, "rad", "And of a heading.", 1e-5, 1.0),
      option("rounds", options.fit.rounds,
             "How often it is looked nearer: bodies imagined, sixty each time.", 1, 10000),
      option("engine", options.engine, "Engine of simulated robots.", engineNames()),
      option("urdf", options.urdf, "Robot description."),
      option("robot_config", options.robot_config, "What the robot needs beside its URDF."),
      option("help", options.help, "Print this text.")};
}

// A pose is measured before and after.
FitOptions fitOptions(const CalibrateOptions& options) {
  FitOptions fit = options.fit;
  fit.seed = static_cast<std::uint64_t>(options.seed);
  fit.noise_m = std::hypot(fit.noise_m, std::sqrt(2.0) * options.noise.position_m);
  fit.noise_rad = std::hypot(fit.noise_rad, std::sqrt(2.0) * options.noise.heading_rad);
  return fit;
}

// Those that tell most, then others drawn among the steady ones.
std::vector<Trial> planOf(const CalibrateOptions& options, const CalibrationSetting& setting,
                          const Repertoire& repertoire) {
  const std::vector<Entry> steady = onlySteady(repertoire.entries, SteadinessOptions());
  std::vector<Trial> plan;
  std::set<std::size_t> chosen;
  for (const std::size_t i : chooseBehaviors(*setting.imagination, setting.learned.physics, steady,
                                             static_cast<std::size_t>(options.behaviors),
                                             setting.fit.noise_m, setting.fit.noise_rad)) {
    plan.push_back({false, {steady[i].genome, {}, {}, {}}});
    chosen.insert(i);
  }
  const auto wanted =
      std::min(chosen.size() + static_cast<std::size_t>(options.checks), steady.size());
  Random random(static_cast<std::uint64_t>(options.seed));
  while (chosen.size() < wanted) {
    const std::size_t i = random.below(steady.size());
    if (chosen.insert(i).second) plan.push_back({true, {steady[i].genome, {}, {}, {}}});
  }
  return plan;
}

void writeResult(const CalibrateOptions& options, const RobotDescription& robot,
                 const Calibration& calibration) {
  const std::string report = reportOf(calibration, robot.name);
  const std::string yaml = calibratedYaml(textOfFile(options.robot_config), options.robot_config,
                                          scalesOf(calibration.fitted.mean));
  writeTextFile(options.output + ".yaml", yaml);
  writeTextFile(options.output + ".md", report);
  writeTextFile(options.output + ".json", pictureData(calibration, robot.name));
  std::cout << report << "\nWrote " << options.output << ".yaml and .md. To learn for this robot:\n"
            << "./run evolve --robot_config " << options.output << ".yaml --from " << options.file
            << " --file new.db\n";
}

void requireOneTask(const CalibrateOptions& options) {
  const int tasks = (options.draws > 0) + !options.simulated.empty() + !options.plan.empty() +
                    !options.trials.empty();
  if (tasks == 1 && !options.file.empty()) return;
  throw std::invalid_argument(
      kCommandLine +
      ": give a repertoire with --file, and one of --simulated, --plan, --trials "
      "and --draws.");
}

CalibrationSetting settingFor(const CalibrateOptions& options, const RobotDescription& robot,
                              const Repertoire& repertoire) {
  if (robot.digest != repertoire.robot_id) {
    throw std::runtime_error("The repertoire was learned for another robot than that of " +
                             options.urdf + " and " + options.robot_config +
                             "; name its files with --urdf and --robot_config.");
  }
  CalibrationSetting setting;
  setting.learned = learnedWorldOf(robot, repertoire);
  setting.imagination = std::make_shared<Imagination>(robot, setting.learned.behavior,
                                                      chooseEngine("reduced", robot).engine,
                                                      static_cast<int>(options.threads));
  setting.engine = chooseEngine(options.engine, robot).engine;
  setting.noise = options.noise;
  setting.fit = fitOptions(options);
  return setting;
}

void calibrateWith(const CalibrateOptions& options) {
  const RobotDescription robot = loadRobot(options.urdf, options.robot_config);
  const Repertoire repertoire = loadRepertoire(options.file);
  CalibrationSetting setting = settingFor(options, robot, repertoire);
  if (!options.trials.empty()) {
    const std::vector<Trial> trials = readTrials(options.trials, robot.geneCount());
    return writeResult(
        options, robot,
        calibrate(setting.imagination, setting.learned.physics, trials, setting.fit));
  }
  setting.plan = planOf(options, setting, repertoire);
  if (!options.plan.empty()) return writePlan(setting.plan, options.plan);
  const auto seed = static_cast<std::uint64_t>(options.seed);
  if (options.draws > 0) {
    const DrawOptions draws{options.draws, options.learn, options.threads, seed};
    return calibrateDraws(setting, repertoire, draws, std::cout);
  }
  const Physics body = bodyFromText(robot, options.simulated, setting.learned.physics);
  const Calibration found = calibrateSimulated(setting, body, seed);
  writeTrials(found.trials, options.output + ".csv");
  writeResult(options, robot, found);
}

std::string help() {
  CalibrateOptions options;
  return helpOn(
      "usage: calibrate --file FILE.db --simulated BODY [--name value ...]\n"
      "       calibrate --file FILE.db --plan PLAN.csv | --trials TRIALS.csv |\n"
      "                 --draws N\n"
      "\n"
      "Finds friction, servo gain, torque and mass of a robot from where some twenty of its "
      "behaviours end, and writes a YAML of the robot to learn with.\n",
      declareOptions(options));
}

int run(const std::vector<std::string>& words) {
  CalibrateOptions options;
  applyOptions(declareOptions(options), valuesFromCommandLine(words, declareOptions(options)),
               kCommandLine);
  if (options.help) {
    std::cout << help();
    return 0;
  }
  requireOneTask(options);
  calibrateWith(options);
  return 0;
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  try {
    return hexapod::run({argv + 1, argv + argc});
  } catch (const std::invalid_argument& error) {
    std::cerr << error.what() << "\ncalibrate --help lists the options.\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
