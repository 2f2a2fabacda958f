#include "learning/resume.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "learning/warm_start.h"

namespace hexapod {
namespace {

using Options = std::map<std::string, std::string>;

std::string textIn(const Options& options, const std::string& name) {
  const auto found = options.find(name);
  return found == options.end() ? "not there" : found->second;
}

/// A line for each difference between the run in the file and the one that is asked for.
std::string differences(const Repertoire& stored, const RobotDescription& robot,
                        const LearnOptions& options) {
  std::string lines;
  const auto add = [&](const std::string& name, const std::string& then, const std::string& now) {
    if (then != now) lines += "\n  " + name + ": " + then + " in the file, " + now + " now";
  };
  Options wanted = resultOptions(options);
  wanted.erase("from");
  if (!options.from.empty()) {
    const auto levels = static_cast<std::size_t>(options.behavior.gene_levels);
    wanted["from"] = warmStart(robot, options.from, levels).name;
  }
  // A file from before there was a choice.
  Options then = stored.options;
  then.emplace("gene_levels", std::to_string(kGeneLevels));
  then.emplace("heading_m_per_rad", "0");
  then.emplace("quality", "orientation_error");
  std::set<std::string> names;
  for (const auto& [name, text] : then) names.insert(name);
  for (const auto& [name, text] : wanted) names.insert(name);
  for (const std::string& name : names) {
    const bool is_told = name != "from" || !options.from.empty();
    if (!isBudget(name) && !isCheck(name) && is_told)
      add(name, textIn(then, name), textIn(wanted, name));
  }
  add("robot", stored.robot_id, robot.digest);
  if (options.evaluations < stored.evaluations) {
    add("evaluations", std::to_string(stored.evaluations) + " done",
        std::to_string(options.evaluations));
  }
  return lines;
}

std::map<std::int64_t, Execution> executionsOf(const std::vector<Entry>& entries) {
  std::map<std::int64_t, Execution> by_id;
  for (const Entry& entry : entries) {
    if (entry.execution) by_id[entry.id] = *entry.execution;
  }
  return by_id;
}

std::string begunWith(const Repertoire& stored) {
  const auto found = stored.options.find("from");
  return found == stored.options.end() ? "" : found->second;
}

bool checksDiffer(const Options& stored, const Options& wanted) {
  const auto differs = [&](const auto& option) {
    return isCheck(option.first) && textIn(stored, option.first) != option.second;
  };
  return std::any_of(wanted.begin(), wanted.end(), differs);
}

}  // namespace

Resumed resume(const RobotDescription& robot, const LearnOptions& options) {
  const StoredRepertoire stored = loadStoredRepertoire(options.repertoire_file);
  const std::string hint =
      "\nNothing was changed: choose another repertoire_file, or set overwrite to true and resume "
      "to "
      "false to replace this one.";
  const std::string start = "The run in " + options.repertoire_file + " cannot be resumed: ";
  const std::string lines = differences(stored.repertoire, robot, options);
  if (!lines.empty()) {
    throw std::invalid_argument(start + "it would not be the same run." + lines + hint);
  }
  try {
    const Repertoire& repertoire = stored.repertoire;
    return {checkpointFrom(stored),
            repertoire.history,
            executionsOf(repertoire.entries),
            repertoire.facts,
            repertoire.trials,
            begunWith(repertoire),
            checksDiffer(repertoire.options, resultOptions(options))};
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(start + error.what() + hint);
  }
}

}  // namespace hexapod
