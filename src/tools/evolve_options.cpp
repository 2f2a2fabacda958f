#include "tools/evolve_options.h"

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>

#include "tools/package_files.h"

namespace hexapod {
namespace {

constexpr const char* kNoPreset = "none";
const std::string kCommandLine = "command line";

using Values = std::map<std::string, OptionValue>;

// In the learner's files, but of no use without ROS.
const std::vector<std::string> kOptionsOfTheNode = {"publish_period_s", "exit_when_done"};

const std::map<std::string, std::string> kShortNames = {
    {"file", "repertoire_file"}, {"seconds", "time_budget_s"}, {"h", "help"}};

std::string fullName(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  const auto found = kShortNames.find(name);
  return found == kShortNames.end() ? name : found->second;
}

const Option* find(const std::vector<Option>& options, const std::string& name) {
  for (const Option& option : options) {
    if (option.name == name) return &option;
  }
  return nullptr;
}

bool isFlag(const Option* option) { return option && std::get_if<bool*>(&option->target); }

bool isText(const Option* option) { return option && std::get_if<std::string*>(&option->target); }

/// One option of the command line, as it stands there.
struct Argument {
  std::string name;
  std::optional<std::string> value;
};

/// The argument at `i`, which moves on to its last word.
Argument argumentAt(const std::vector<std::string>& words, std::size_t& i,
                    const std::vector<Option>& options) {
  const std::string& word = words[i];
  const std::size_t dashes = word.rfind("--", 0) == 0 ? 2 : 1;
  if (word.size() <= dashes || word[0] != '-') {
    throw std::invalid_argument(kCommandLine + ": '" + word +
                                "' is no option; expected --name value, e.g. --seed 3.");
  }
  const std::size_t equals = word.find('=');
  Argument argument{fullName(word.substr(dashes, equals - dashes)), std::nullopt};
  if (equals != std::string::npos) {
    argument.value = word.substr(equals + 1);
    return argument;
  }
  const bool has_next = i + 1 < words.size() && words[i + 1].rfind("--", 0) != 0;
  const bool takes_next = has_next && (!isFlag(find(options, argument.name)) ||
                                       words[i + 1] == "true" || words[i + 1] == "false");
  if (takes_next) argument.value = words[++i];
  return argument;
}

OptionValue valueOf(const Argument& argument, const Option* option) {
  if (!argument.value && isFlag(option)) return true;
  if (!argument.value && option) {
    throw std::invalid_argument(kCommandLine + ": '" + argument.name + "' has no value; expected " +
                                option->range() + ".");
  }
  const std::string text = argument.value.value_or("");
  return isText(option) ? OptionValue(text) : optionValueFromText(text);
}

Values valuesFrom(const std::vector<std::string>& words, const std::vector<Option>& options) {
  Values values;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const Argument argument = argumentAt(words, i, options);
    const OptionValue value = valueOf(argument, find(options, argument.name));
    if (!values.emplace(argument.name, value).second) {
      throw std::invalid_argument(kCommandLine + ": '" + argument.name +
                                  "' stands there twice; keep one.");
    }
  }
  return values;
}

void applyFile(const std::string& file, EvolveOptions& options) {
  Values values = optionValuesFromYaml(file);
  for (const std::string& name : kOptionsOfTheNode) values.erase(name);
  applyOptions(declareOptions(options), values, file);
}

void setToShipped(std::string& path, const std::string& file) {
  if (path.empty()) path = packageFolder() + "/" + file;
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
  const Values values = valuesFrom(arguments, declareOptions(options));
  // A first look, for what names the files that come before the command line.
  applyOptions(declareOptions(options), values, kCommandLine);
  if (options.help) return options;
  if (options.preset != kNoPreset) applyFile(presetFile(packageFolder(), options.preset), options);
  if (!options.config.empty()) applyFile(options.config, options);
  applyOptions(declareOptions(options), values, kCommandLine);
  if (values.count("time_budget_s") > 0 && values.count("evaluations") == 0) {
    options.learn.evaluations =
        static_cast<std::int64_t>(find(declareOptions(options), "evaluations")->max);
  }
  setToShipped(options.urdf, "urdf/hexapod.urdf");
  setToShipped(options.robot_config, "config/hexapod.yaml");
  if (options.learn.repertoire_file.empty()) {
    throw std::invalid_argument(kCommandLine +
                                ": give the file to learn into, e.g. --file gaits.db.");
  }
  return options;
}

std::string evolveHelp() {
  EvolveOptions options;
  return "usage: evolve --file FILE.db [--name value ...]\n\n"
         "Learns a repertoire of gaits, without ROS. Same options and seed, same repertoire as "
         "the\n"
         "node learner's. Ctrl-C saves and ends; --resume goes on.\n\n"
         "  evolve --file gaits.db --evaluations 20000 --seed 3\n"
         "  evolve --file gaits.db --evaluations 50000 --seed 3 --resume\n"
         "  evolve --file gaits.db --preset paper --novelty_threshold_m 0.05 --csv gaits.csv\n"
         "  evolve --file gaits.db --seconds 60      (how far it gets depends on the machine)\n"
         "  mpirun -n 8 evolve --file gaits.db --evaluations 1000000       (same result as "
         "alone)\n\n"
         "--file is short for --repertoire_file, --seconds for --time_budget_s without a limit of\n"
         "evaluations. The preset's options come first, then those of --config, then these.\n\n" +
         describeOptions(declareOptions(options));
}

}  // namespace hexapod
