#include "tools/command_line.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace hexapod {

const std::string kCommandLine = "command line";

namespace {

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

/// Reads one argument after the other.
class Arguments {
 public:
  Arguments(const std::vector<std::string>& words, const std::vector<Option>& options,
            const std::map<std::string, std::string>& short_names)
      : words_(words), options_(options), short_names_(short_names) {}

  bool areLeft() const { return next_ < words_.size(); }

  Argument take() {
    const std::string& word = words_[next_++];
    const std::size_t assignment = word.find(":=");
    if (word[0] != '-' && assignment != std::string::npos) {
      return {fullName(word.substr(0, assignment)), word.substr(assignment + 2)};
    }
    const std::size_t dashes = word.rfind("--", 0) == 0 ? 2 : 1;
    if (word.size() <= dashes || word[0] != '-') {
      throw std::invalid_argument(kCommandLine + ": '" + word +
                                  "' is no option; expected --name value, e.g. --seed 3.");
    }
    const std::size_t equals = word.find('=');
    Argument argument{fullName(word.substr(dashes, equals - dashes)), std::nullopt};
    if (equals != std::string::npos) {
      argument.value = word.substr(equals + 1);
    } else if (nextIsValueOf(argument.name)) {
      argument.value = words_[next_++];
    }
    return argument;
  }

 private:
  std::string fullName(std::string name) const {
    std::replace(name.begin(), name.end(), '-', '_');
    const auto found = short_names_.find(name);
    return found == short_names_.end() ? name : found->second;
  }

  bool nextIsValueOf(const std::string& name) const {
    if (!areLeft() || words_[next_].rfind("--", 0) == 0) return false;
    return !isFlag(find(options_, name)) || words_[next_] == "true" || words_[next_] == "false";
  }

  const std::vector<std::string>& words_;
  const std::vector<Option>& options_;
  const std::map<std::string, std::string>& short_names_;
  std::size_t next_ = 0;
};

// Of other names applyOptions() does not know.
void refuseMisspeltShortName(const std::string& name, const std::vector<Option>& options,
                             const std::map<std::string, std::string>& short_names) {
  std::vector<std::string> names;
  for (const Option& option : options) names.push_back(option.name);
  for (const auto& [short_name, full_name] : short_names) names.push_back(short_name);
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  const std::string nearest = nearestName(name, names);
  if (short_names.count(nearest) == 0) return;
  throw std::invalid_argument(kCommandLine + ": '" + name +
                              "' is not a known option; did you mean '" + nearest + "'.");
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

}  // namespace

std::map<std::string, OptionValue> valuesFromCommandLine(
    const std::vector<std::string>& words, const std::vector<Option>& options,
    const std::map<std::string, std::string>& short_names) {
  std::map<std::string, OptionValue> values;
  Arguments arguments(words, options, short_names);
  while (arguments.areLeft()) {
    const Argument argument = arguments.take();
    refuseMisspeltShortName(argument.name, options, short_names);
    const OptionValue value = valueOf(argument, find(options, argument.name));
    if (values.emplace(argument.name, value).second) continue;
    throw std::invalid_argument(kCommandLine + ": '" + argument.name +
                                "' stands there twice; keep one.");
  }
  return values;
}

}  // namespace hexapod
