#pragma once

#include <yaml-cpp/yaml.h>

#include <set>
#include <string>
#include <vector>

#include "common/problems.h"

namespace hexapod {

/// A mapping of a YAML file, read strictly: every key that is asked for must be there with the
/// right type and range, every key that is there must be asked for before finish().
///
/// Problems are collected with file, line and full key ("servo.gain_per_s"); values that have one
/// come back empty or as the lower end of their range.
class YamlSection {
 public:
  /// `path` is the section's full key, "" for the whole file. A node that is no mapping is a
  /// problem.
  YamlSection(const YAML::Node& node, std::string path, std::string source, Problems& problems);

  /// Text of 1 .. 100 characters.
  std::string text(const std::string& key);

  /// A finite number in min .. max; `unit` is for the sentence.
  double number(const std::string& key, double min, double max, const std::string& unit);

  /// The mapping under `key`.
  YamlSection section(const std::string& key);

  /// The elements of the list under `key`; at least one.
  std::vector<YAML::Node> list(const std::string& key);

  /// Whether `key` is there; it may then be asked for.
  bool has(const std::string& key);

  /// Adds a problem for every key nobody asked for, with the nearest known one.
  void finish();

  /// Adds a problem about a key of this section: "line 3: servo.gain_per_s " + sentence.
  void addProblem(const std::string& key, const std::string& sentence);

 private:
  YAML::Node find(const std::string& key, const std::string& expected);
  std::string fullKey(const std::string& key) const;

  YAML::Node node_;
  std::string path_;
  std::string source_;
  Problems* problems_;
  bool is_map_;
  std::vector<std::string> known_;
};

}  // namespace hexapod
