#include "execution/joint_map.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>

#include "common/options.h"
#include "common/problems.h"

namespace hexapod {
namespace {

// Takes one sentence about what is wrong with the file.
using Complain = std::function<void(const std::string&)>;

double number(const YAML::Node& node, const std::string& what, const Complain& complain) {
  const OptionValue value = optionValueFromText(node.IsScalar() ? node.Scalar() : "");
  if (const auto* real = std::get_if<double>(&value)) return *real;
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return static_cast<double>(*integer);
  complain(what + " must be a number.");
  return 0.0;
}

WireJoint parseJoint(const std::string& joint, const YAML::Node& node, const Complain& complain) {
  WireJoint wire{joint, joint, 1.0, 0.0};
  if (!node.IsMap()) {
    complain("joint '" + joint + "' must hold name, sign and offset_rad.");
    return wire;
  }
  for (const auto& field : node) {
    const std::string key = field.first.Scalar();
    const std::string what = "'" + key + "' of joint '" + joint + "'";
    if (key == "name") {
      wire.name = field.second.IsScalar() ? field.second.Scalar() : "";
      if (wire.name.empty()) complain(what + " must be a name.");
    } else if (key == "sign") {
      wire.sign = number(field.second, what, complain);
      if (std::abs(wire.sign) != 1.0) complain(what + " must be 1 or -1.");
    } else if (key == "offset_rad") {
      wire.offset_rad = number(field.second, what, complain);
      if (!std::isfinite(wire.offset_rad)) complain(what + " must be finite.");
    } else {
      complain(what + " is unknown; expected name, sign or offset_rad.");
    }
  }
  return wire;
}

YAML::Node jointsNode(const std::string& text, const Complain& complain) {
  YAML::Node root;
  try {
    root = YAML::Load(text);
  } catch (const YAML::Exception& error) {
    complain(std::string("this is not YAML: ") + error.what() + ".");
    return YAML::Node(YAML::NodeType::Map);
  }
  if (!root.IsMap() || !root["joints"] || !root["joints"].IsMap()) {
    complain("expected a map 'joints' with one entry per joint of the robot.");
    return YAML::Node(YAML::NodeType::Map);
  }
  for (const auto& entry : root) {
    if (entry.first.Scalar() == "joints") continue;
    complain("key '" + entry.first.Scalar() + "' is unknown; expected joints.");
  }
  return root["joints"];
}

}  // namespace

JointMap JointMap::identity(const std::vector<std::string>& joint_names) {
  std::vector<WireJoint> joints;
  for (const std::string& name : joint_names) joints.push_back({name, name, 1.0, 0.0});
  return JointMap(std::move(joints));
}

JointMap JointMap::fromYaml(const std::string& text, const std::vector<std::string>& joint_names,
                            const std::string& source) {
  Problems problems;
  const Complain complain = [&](const std::string& what) { problems.add(source, what); };
  const YAML::Node node = jointsNode(text, complain);
  problems.throwIfAny();
  std::vector<WireJoint> joints(joint_names.size());
  std::set<std::string> wire_names;
  for (const auto& entry : node) {
    const std::string joint = entry.first.Scalar();
    const auto found = std::find(joint_names.begin(), joint_names.end(), joint);
    if (found == joint_names.end()) {
      complain("joint '" + joint + "' is not one of the robot's.");
      continue;
    }
    WireJoint& slot = joints[static_cast<std::size_t>(found - joint_names.begin())];
    if (!slot.joint.empty()) complain("joint '" + joint + "' occurs twice.");
    slot = parseJoint(joint, entry.second, complain);
    if (!wire_names.insert(slot.name).second) {
      complain("the name '" + slot.name + "' is given to two joints.");
    }
  }
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (joints[j].joint.empty()) complain("joint '" + joint_names[j] + "' is missing.");
  }
  problems.throwIfAny();
  return JointMap(std::move(joints));
}

std::vector<std::string> JointMap::wireNames() const {
  std::vector<std::string> names;
  for (const WireJoint& joint : joints_) names.push_back(joint.name);
  return names;
}

void JointMap::toWire(const std::vector<double>& angles_rad, std::vector<double>& wire_rad) const {
  wire_rad.resize(joints_.size());
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    wire_rad[j] = joints_[j].sign * angles_rad[j] + joints_[j].offset_rad;
  }
}

void JointMap::fromWire(const std::vector<double>& wire_rad,
                        std::vector<double>& angles_rad) const {
  angles_rad.resize(joints_.size());
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    angles_rad[j] = joints_[j].sign * (wire_rad[j] - joints_[j].offset_rad);
  }
}

}  // namespace hexapod
