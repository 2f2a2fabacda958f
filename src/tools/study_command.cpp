#include "tools/study_command.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

#include "common/options_help.h"
#include "learning/learn_options.h"
#include "study/methods.h"
#include "tools/command_line.h"
#include "tools/learner_file.h"
#include "tools/package_files.h"

namespace hexapod {
namespace {

// A study of a few minutes, up to the first of the paper's two marks.
constexpr std::int64_t kQuickRuns = 5;
constexpr std::int64_t kQuickEvaluations = 100000;

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ",") + word;
  return text;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, ',');) words.push_back(word);
  return words;
}

void requireKnownAlgorithms(const std::string& algorithms) {
  const std::vector<std::string> known = methodNames();
  const std::vector<std::string> named = split(algorithms);
  for (const std::string& name : named) {
    if (std::count(known.begin(), known.end(), name) > 0 &&
        std::count(named.begin(), named.end(), name) == 1) {
      continue;
    }
    throw std::invalid_argument(kCommandLine + ": 'algorithms' is '" + algorithms +
                                "', expected some of " + joined(known) + ", each once.");
  }
}

std::set<std::string> namesOf(const std::vector<Option>& options) {
  std::set<std::string> names;
  for (const Option& option : options) names.insert(option.name);
  return names;
}

/// A file of the learner's options: those that a study has, too, are taken.
void applyLearnFile(const std::string& file, StudyOptions& study) {
  LearnOptions learn;
  const std::set<std::string> of_study = namesOf(declareOptions(study));
  std::map<std::string, OptionValue> values = valuesFromLearnerFile(file);
  for (const std::string& name : namesOf(declareOptions(learn))) {
    if (of_study.count(name) == 0) values.erase(name);
  }
  applyOptions(declareOptions(study), values, file);
}

}  // namespace

std::vector<Option> declareOptions(StudyCommand& command) {
  constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
  std::vector<Option> all = {
      option("help", command.help, "Print this text."),
      option("folder", command.folder, "Folder of the study, made when there is none."),
      option("algorithms", command.algorithms, "Algorithms to run, with commas between."),
      option("runs", command.runs, "Runs of each algorithm, with seeds one after the other.", 1,
             100000),
      option("first_seed", command.first_seed, "Seed of the first run.", 0, kMost / 2),
      option("evaluations", command.evaluations, "Candidates of each run.", 1, kMost),
      option("quick", command.quick, "5 runs of 100000 evaluations, unless told otherwise."),
      option("jobs", command.jobs,
             "Runs at a time; 0: one for each core, shared among the processes of an mpirun.", 0,
             1024),
      option("preset", command.preset, "Start from the options in config/NAME.yaml."),
      option("config", command.config, "YAML file with options, on top of the preset."),
      option("urdf", command.urdf, "URDF of the robot; empty: the shipped one."),
      option("robot_config", command.robot_config,
             "YAML of the robot: legs, gait, servo, contact; empty: the shipped one.")};
  const std::vector<Option> study = declareOptions(command.study);
  all.insert(all.end(), study.begin(), study.end());
  return all;
}

StudyCommand studyCommandFrom(const std::vector<std::string>& arguments) {
  StudyCommand command;
  const auto values = valuesFromCommandLine(arguments, declareOptions(command), {{"h", "help"}});
  // A first look, for what names the files that come before the command line.
  applyOptions(declareOptions(command), values, kCommandLine);
  if (command.help) return command;
  if (command.quick) {
    command.runs = kQuickRuns;
    command.evaluations = kQuickEvaluations;
  }
  applyLearnFile(presetFile(packageFolder(), command.preset), command.study);
  if (!command.config.empty()) applyLearnFile(command.config, command.study);
  applyOptions(declareOptions(command), values, kCommandLine);
  requireKnownAlgorithms(command.algorithms);
  if (command.urdf.empty()) command.urdf = packageFolder() + "/urdf/hexapod.urdf";
  if (command.robot_config.empty()) {
    command.robot_config = packageFolder() + "/config/hexapod.yaml";
  }
  return command;
}

std::vector<RunPlan> plansOf(const StudyCommand& command) {
  std::vector<RunPlan> plans;
  for (std::int64_t run = 0; run < command.runs; ++run) {
    for (const std::string& algorithm : split(command.algorithms)) {
      plans.push_back({algorithm, command.first_seed + run, command.evaluations});
    }
  }
  return plans;
}

std::string studyHelp() {
  StudyCommand command;
  return helpOn(
      "usage: study [--name value ...]\n"
      "\n"
      "Repeats the study of Cully & Mouret 2013: BR-Evolution, the control experiments \"nearest\" "
      "and \"orientation\" (both chosen from the runs of the algorithm targets), and MAP-Elites. "
      "Each run has one thread and a folder of its own; started again, the study goes on with the "
      "runs that are not finished. study_report.py FOLDER draws the figures.\n"
      "\n"
      "  study --quick --folder quick\n"
      "  study --folder paper                  (40 runs of 1,000,000)\n"
      "  study --folder paper --runs 20 --evaluations 100000\n"
      "  mpirun -n 64 study --folder paper     (on a file system they share)\n",
      declareOptions(command));
}

}  // namespace hexapod
