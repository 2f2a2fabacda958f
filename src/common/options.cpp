#include "common/options.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "common/text.h"

namespace hexapod {
namespace {

template <typename... Visitors>
struct Overloaded : Visitors... {
  using Visitors::operator()...;
};
template <typename... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;

std::string valueText(const OptionValue& value) {
  return std::visit(Overloaded{[](bool v) { return std::string(v ? "true" : "false"); },
                               [](std::int64_t v) { return std::to_string(v); },
                               [](double v) { return exactText(v); },
                               [](const std::string& v) { return "the text '" + v + "'"; }},
                    value);
}

std::string expectedType(const Option& option) {
  return std::visit(
      Overloaded{[](bool*) { return "true or false"; },
                 [](std::int64_t*) { return "a whole number"; }, [](double*) { return "a number"; },
                 [](std::string*) { return "a text"; }},
      option.target);
}

std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row.back();
}

// Checks one value; returns the problem as a sentence, or "" after storing it when `store`.
std::string assign(const Option& option, const OptionValue& value, bool store) {
  const auto wrongType = [&] {
    std::string sentence = "expected " + expectedType(option) + ", found " + valueText(value);
    const auto* text = std::get_if<std::string>(&value);
    const auto number = text ? doubleFromText(*text) : std::nullopt;
    if (number && !std::get_if<std::string*>(&option.target)) {
      sentence +=
          " (YAML reads a number in quotes, or with an exponent but no dot, as text: write " +
          exactText(*number) + ")";
    }
    return sentence;
  };
  const auto inRange = [&](double number) {
    return std::isfinite(number) && number >= option.min && number <= option.max;
  };
  const auto outOfRange = [&] {
    return "expected " + option.range() + ", found " + valueText(value);
  };
  if (const auto* target = std::get_if<bool*>(&option.target)) {
    const auto* flag = std::get_if<bool>(&value);
    if (!flag) return wrongType();
    if (store) **target = *flag;
  } else if (const auto* target = std::get_if<std::int64_t*>(&option.target)) {
    const auto* number = std::get_if<std::int64_t>(&value);
    if (!number) return wrongType();
    if (*number < option.min || *number > option.max) return outOfRange();
    if (store) **target = *number;
  } else if (const auto* target = std::get_if<double*>(&option.target)) {
    const auto* whole = std::get_if<std::int64_t>(&value);
    const auto* real = std::get_if<double>(&value);
    if (!whole && !real) return wrongType();
    const double number = real ? *real : static_cast<double>(*whole);
    if (!inRange(number)) return outOfRange();
    if (store) **target = number;
  } else {
    const auto* text = std::get_if<std::string>(&value);
    if (!text) return wrongType();
    const auto& choices = option.choices;
    if (!choices.empty() && std::find(choices.begin(), choices.end(), *text) == choices.end()) {
      return outOfRange();
    }
    if (store) *std::get<std::string*>(option.target) = *text;
  }
  return "";
}

}  // namespace

std::string nearestName(const std::string& name, const std::vector<std::string>& known) {
  std::string nearest;
  std::size_t least = name.size() / 2 + 1;
  for (const std::string& candidate : known) {
    const std::size_t edits = editDistance(name, candidate);
    if (edits < least) {
      least = edits;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string Option::text() const {
  return std::visit(
      Overloaded{[](bool* v) { return std::string(*v ? "true" : "false"); },
                 [](std::int64_t* v) { return std::to_string(*v); },
                 [](double* v) { return exactText(*v); }, [](std::string* v) { return *v; }},
      target);
}

std::string Option::range() const {
  if (std::get_if<bool*>(&target)) return "true or false";
  if (std::get_if<std::string*>(&target)) {
    if (choices.empty()) return "text";
    std::string all;
    for (const std::string& choice : choices) all += (all.empty() ? "" : " or ") + choice;
    return all;
  }
  return exactText(min) + " .. " + exactText(max) + (unit.empty() ? "" : " " + unit);
}

Option option(const std::string& name, bool& target, const std::string& meaning) {
  return {name, &target, "", meaning, 0.0, 0.0, {}};
}

Option option(const std::string& name, std::string& target, const std::string& meaning,
              std::vector<std::string> choices) {
  return {name, &target, "", meaning, 0.0, 0.0, std::move(choices)};
}

Option option(const std::string& name, std::int64_t& target, const std::string& meaning,
              std::int64_t min, std::int64_t max) {
  return {name, &target, "", meaning, static_cast<double>(min), static_cast<double>(max), {}};
}

Option option(const std::string& name, double& target, const std::string& unit,
              const std::string& meaning, double min, double max) {
  return {name, &target, unit, meaning, min, max, {}};
}

void applyOptions(const std::vector<Option>& options,
                  const std::map<std::string, OptionValue>& values, const std::string& source) {
  std::vector<std::string> names;
  for (const Option& option : options) names.push_back(option.name);
  std::string problems;
  for (const auto& [name, value] : values) {
    const auto found = std::find(names.begin(), names.end(), name);
    std::string problem;
    if (found == names.end()) {
      const std::string nearest = nearestName(name, names);
      problem = "is not a known option" +
                (nearest.empty() ? std::string("; remove it") : "; did you mean '" + nearest + "'");
    } else {
      problem = assign(options[found - names.begin()], value, false);
    }
    if (!problem.empty()) {
      problems += (problems.empty() ? "" : "\n") + source + ": '" + name + "' " +
                  (found == names.end() ? "" : "is wrong: ") + problem + ".";
    }
  }
  if (!problems.empty()) throw std::invalid_argument(problems);
  for (const auto& [name, value] : values) {
    assign(options[std::find(names.begin(), names.end(), name) - names.begin()], value, true);
  }
}

OptionValue optionValueFromText(const std::string& text) {
  if (text == "true" || text == "True") return true;
  if (text == "false" || text == "False") return false;
  if (const auto whole = integerFromText(text)) return *whole;
  // As in YAML 1.1, and so on the parameter server: a number without a dot is a whole number or
  // text.
  const auto real = text.find('.') != std::string::npos ? doubleFromText(text) : std::nullopt;
  return real ? OptionValue(*real) : OptionValue(text);
}

void applyKept(const std::vector<Option>& options, const std::map<std::string, std::string>& texts,
               const std::string& source) {
  std::map<std::string, OptionValue> values;
  for (const Option& option : options) {
    const auto found = texts.find(option.name);
    if (found != texts.end()) values[option.name] = optionValueFromText(found->second);
  }
  applyOptions(options, values, source);
}

std::map<std::string, OptionValue> optionValuesFromYaml(const std::string& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream.is_open() || text.bad()) {
    throw std::runtime_error(file + ": cannot be read; give the path of an existing YAML file.");
  }
  return optionValuesFromYamlText(text.str(), file);
}

std::map<std::string, OptionValue> optionValuesFromYamlText(const std::string& text,
                                                            const std::string& source) {
  std::map<std::string, OptionValue> values;
  try {
    const YAML::Node root = YAML::Load(text);
    if (root.IsNull()) return values;
    if (!root.IsMap()) throw std::runtime_error(source + ": expected lines 'key: value'.");
    for (const auto& pair : root) {
      const std::string key = pair.first.as<std::string>();
      if (!pair.second.IsScalar()) {
        throw std::runtime_error(source + ": line " + std::to_string(pair.second.Mark().line + 1) +
                                 ": '" + key + "' expects a single value.");
      }
      const bool quoted = pair.second.Tag() == "!";
      const std::string scalar = pair.second.Scalar();
      if (!values.emplace(key, quoted ? OptionValue(scalar) : optionValueFromText(scalar)).second) {
        throw std::runtime_error(source + ": '" + key + "' stands there twice; keep one.");
      }
    }
  } catch (const YAML::Exception& error) {
    throw std::runtime_error(source + ": line " + std::to_string(error.mark.line + 1) +
                             ": not YAML: " + error.msg + ".");
  }
  return values;
}

std::string describeOptions(const std::vector<Option>& options) {
  std::string table = "| option | default | range | meaning |\n|---|---|---|---|\n";
  for (const Option& option : options) {
    table += "| `" + option.name + "` | " + (option.text().empty() ? "\"\"" : option.text()) +
             " | " + option.range() + " | " + option.meaning + " |\n";
  }
  return table;
}

}  // namespace hexapod
