#include "tools/evolve_options.h"

#include <map>
#include <stdexcept>

#include "common/options_help.h"
#include "tools/command_line.h"
#include "tools/learner_file.h"
#include "tools/package_files.h"
#include "tools/same_file.h"

namespace hexapod {
namespace {

constexpr const char* kNoPreset = "none";

const std::map<std::string, std::string> kShortNames = {
    {"file", "repertoire_file"}, {"seconds", "time_budget_s"}, {"h", "help"}};

void applyFile(const std::string& file, EvolveOptions& options) {
  applyOptions(declareOptions(options), valuesFromLearnerFile(file), file);
}

void setToShipped(std::string& path, const std::string& file) {
  if (path.empty()) path = packageFolder() + "/" + file;
}

/// The CSV file must not take the place of the repertoire, nor of what is kept beside it.
void requireOtherFile(const std::string& csv, const std::string& repertoire_file) {
  for (const char* ending : {"", ".lock", "-journal"}) {
    if (csv.empty() || !isSameFile(csv, repertoire_file + ending)) continue;
    throw std::invalid_argument(kCommandLine + ": 'csv' and 'file' are the same file, " + csv +
                                "; give two, as the repertoire would be overwritten.");
  }
}

}  // namespace

std::vector<Option> declareOptions(EvolveOptions& options) {
  std::vector<Option> all = {
      option("help", options.help, "Print this text."),
      option("preset", options.preset,
             "Start from config/NAME.yaml or config/learn_NAME.yaml; none: from the defaults."),
      option("config", options.config, "YAML file with options, on top of the preset."),
      option("urdf", options.urdf, "URDF of the robot; empty: the shipped one."),
      option("robot_config", options.robot_config,
             "YAML of the robot: legs, gait, servo, contact; empty: the shipped one."),
      option("csv", options.csv, "Also write the entries to this file, comma separated."),
      option("progress_period_s", options.progress_period_s, "s",
             "Time between two lines where the output is no terminal; 0: after every generation.",
             0.0, 86400.0)};
  const std::vector<Option> learn = declareOptions(options.learn);
  all.insert(all.end(), learn.begin(), learn.end());
  return all;
}

EvolveOptions evolveOptionsFrom(const std::vector<std::string>& arguments) {
  EvolveOptions options;
  const auto values = valuesFromCommandLine(arguments, declareOptions(options), kShortNames);
  // A first look, for what names the files that come before the command line.
  applyOptions(declareOptions(options), values, kCommandLine);
  if (options.preset != kNoPreset) applyFile(presetFile(packageFolder(), options.preset), options);
  if (!options.config.empty()) applyFile(options.config, options);
  applyOptions(declareOptions(options), values, kCommandLine);
  if (options.help) return options;
  setToShipped(options.urdf, "urdf/hexapod.urdf");
  setToShipped(options.robot_config, "config/hexapod.yaml");
  if (options.learn.repertoire_file.empty()) {
    throw std::invalid_argument(kCommandLine +
                                ": give the file to learn into, e.g. --file gaits.db.");
  }
  requireOtherFile(options.csv, options.learn.repertoire_file);
  return options;
}

std::string evolveHelp(EvolveOptions options) {
  return helpOn(
      "usage: evolve --file FILE.db [--name value ...]\n"
      "\n"
      "Learns a repertoire of gaits, without ROS. Same options and seed, same repertoire as the "
      "node learner's. Ctrl-C saves and ends; --resume goes on.\n"
      "\n"
      "  evolve --file gaits.db --evaluations 20000 --seed 3\n"
      "  evolve --file gaits.db --evaluations 50000 --seed 3 --resume\n"
      "  evolve --file gaits.db --preset paper --novelty_threshold_m 0.05\n"
      "  evolve --file gaits.db --seconds 60   (how far depends on the machine)\n"
      "  mpirun -n 8 evolve --file gaits.db --evaluations 1000000   (same result)\n"
      "\n"
      "--file is short for --repertoire_file, --seconds for --time_budget_s. The preset's options "
      "come first, then those of --config, then these. In brackets: the values with which it would "
      "begin.\n",
      declareOptions(options));
}

}  // namespace hexapod
