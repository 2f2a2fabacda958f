#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace hexapod {

/// A value as a parameter server or a YAML file holds it.
using OptionValue = std::variant<bool, std::int64_t, double, std::string>;

/// One declared option: the single home of its name, unit, range and meaning, bound to the field
/// that holds its default and receives its value. Parameter server, YAML files, command lines, help
/// texts and doc/options.md all come from it.
struct Option {
  using Target = std::variant<bool*, std::int64_t*, double*, std::string*>;

  std::string name;  ///< snake_case with the unit as suffix
  Target target;
  std::string unit;     ///< "" when it has none
  std::string meaning;  ///< one sentence
  double min = 0.0;     ///< numbers: inclusive range
  double max = 0.0;
  std::vector<std::string> choices;  ///< strings: the allowed ones; empty: any

  /// Value now, as text: "0.1", "true", "ode".
  std::string text() const;
  /// "0 .. 1 m", "ode or reduced", "true or false", "text".
  std::string range() const;
};

Option option(const std::string& name, bool& target, const std::string& meaning);
Option option(const std::string& name, std::string& target, const std::string& meaning,
              std::vector<std::string> choices = {});
/// Numbers carry an inclusive range; `unit` is "" for counts and ratios.
Option option(const std::string& name, std::int64_t& target, const std::string& meaning,
              std::int64_t min, std::int64_t max);
Option option(const std::string& name, double& target, const std::string& unit,
              const std::string& meaning, double min, double max);

/// Sets the options from named values. An integer is accepted for a double, nothing else is
/// converted. Throws std::invalid_argument listing every problem at once, one sentence a line, each
/// naming the key, `source` (a file or node), what was expected, what was found: unknown key (with
/// the nearest known name), wrong type (numbers written as text get told so: YAML reads 1e-2 as
/// text), out of range, not finite. Nothing is set when anything is wrong.
void applyOptions(const std::vector<Option>& options,
                  const std::map<std::string, OptionValue>& values, const std::string& source);

/// Sets those of the options that are among `texts`, as a file keeps them by name; others there are
/// left alone. Throws as applyOptions() does.
void applyKept(const std::vector<Option>& options, const std::map<std::string, std::string>& texts,
               const std::string& source);

/// Flat map of a YAML file: key: scalar. Throws std::runtime_error naming file and line.
std::map<std::string, OptionValue> optionValuesFromYaml(const std::string& file);

/// The same from a text; `source` stands for the file in messages.
std::map<std::string, OptionValue> optionValuesFromYamlText(const std::string& text,
                                                            const std::string& source);

/// A scalar as YAML 1.1 and roscpp type it: 3 integer, 3.0 and 1.0e-2 double, true/false bool, else
/// text.
OptionValue optionValueFromText(const std::string& text);

/// The known name nearest to a misspelt one, or "" when none is near.
std::string nearestName(const std::string& name, const std::vector<std::string>& known);

/// A Markdown table of the options: name, value now, range with unit, meaning.
std::string describeOptions(const std::vector<Option>& options);

}  // namespace hexapod
