#include "robot/yaml_section.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "common/options.h"
#include "common/text.h"

namespace hexapod {
namespace {

std::string described(const YAML::Node& node) {
  if (node.IsMap()) return "a mapping";
  if (node.IsSequence()) return "a list";
  if (node.IsNull()) return "nothing";
  return "\"" + node.Scalar().substr(0, 100) + "\"";
}

// yaml-cpp tags quoted scalars "!": they are text even when they look like a number.
bool isNumber(const YAML::Node& node, double& value) {
  if (!node.IsScalar() || node.Tag() == "!") return false;
  const OptionValue read = optionValueFromText(node.Scalar());
  if (const auto* whole = std::get_if<std::int64_t>(&read)) {
    value = static_cast<double>(*whole);
  } else if (const auto* real = std::get_if<double>(&read)) {
    value = *real;
  } else {
    return false;
  }
  return std::isfinite(value);
}

}  // namespace

YamlSection::YamlSection(const YAML::Node& node, std::string path, std::string source,
                         Problems& problems)
    : node_(node),
      path_(std::move(path)),
      source_(std::move(source)),
      problems_(&problems),
      is_map_(node.IsMap()) {
  if (!is_map_) addProblem("", "should be a mapping (key: value), found " + described(node) + ".");
}

std::string YamlSection::text(const std::string& key) {
  const YAML::Node node = find(key, "a text");
  if (!node) return "";
  if (!node.IsScalar() || node.Scalar().empty() || node.Scalar().size() > 100) {
    addProblem(key, "should be a text of 1 to 100 characters, found " + described(node) + ".");
    return "";
  }
  return node.Scalar();
}

double YamlSection::number(const std::string& key, double min, double max,
                           const std::string& unit) {
  const std::string expected = "a number from " + numberText(min) + " to " + numberText(max) +
                               (unit.empty() ? "" : " [" + unit + "]");
  const YAML::Node node = find(key, expected);
  if (!node) return min;
  double value = 0.0;
  if (!isNumber(node, value)) {
    addProblem(key, "should be " + expected + ", found " + described(node) +
                        "; write numbers with a decimal point and without quotes (1.0e-5).");
    return min;
  }
  if (value < min || value > max) {
    addProblem(key, "should be " + expected + ", found " + numberText(value) + ".");
    return min;
  }
  return value;
}

YamlSection YamlSection::section(const std::string& key) {
  const YAML::Node node = find(key, "a mapping");
  // What is missing has been told once; an empty mapping would tell each of its keys again.
  YamlSection section(node ? node : YAML::Node(YAML::NodeType::Map), fullKey(key), source_,
                      *problems_);
  if (!node) section.is_map_ = false;
  return section;
}

std::vector<YAML::Node> YamlSection::list(const std::string& key) {
  const YAML::Node node = find(key, "a list");
  if (!node) return {};
  if (!node.IsSequence() || node.size() == 0) {
    addProblem(key, "should be a list of at least one element, found " +
                        (node.IsSequence() ? "none" : described(node)) + ".");
    return {};
  }
  return {node.begin(), node.end()};
}

bool YamlSection::has(const std::string& key) {
  known_.push_back(key);
  const YAML::Node& node = node_;
  return is_map_ && node[key].IsDefined();
}

void YamlSection::finish() {
  if (!is_map_) return;
  std::set<std::string> seen;
  for (const auto& pair : node_) {
    const std::string key = pair.first.IsScalar() ? pair.first.Scalar() : "";
    if (!seen.insert(key).second) addProblem(key, "is there twice; remove one.");
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    const std::string nearest = nearestName(key, known_);
    addProblem(key, "is not a known key; " +
                        (nearest.empty() ? "remove it." : "did you mean " + nearest + "?"));
  }
}

void YamlSection::addProblem(const std::string& key, const std::string& sentence) {
  const YAML::Node& node = node_;
  const bool has_value = is_map_ && !key.empty() && node[key].IsDefined();
  const YAML::Mark mark = has_value ? node[key].Mark() : node.Mark();
  const std::string line = mark.is_null() ? "" : "line " + std::to_string(mark.line + 1) + ": ";
  const std::string name = fullKey(key);
  problems_->add(source_, line + (name.empty() ? "the file" : name) + " " + sentence);
}

YAML::Node YamlSection::find(const std::string& key, const std::string& expected) {
  if (has(key)) return node_[key];
  if (is_map_) addProblem(key, "is missing; expected " + expected + ".");
  return YAML::Node(YAML::NodeType::Undefined);
}

std::string YamlSection::fullKey(const std::string& key) const {
  return path_ + (path_.empty() || key.empty() ? "" : ".") + key;
}

}  // namespace hexapod
