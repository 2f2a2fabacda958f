#include "robot/robot_config.h"

#include <array>
#include <cmath>
#include <set>

#include "robot/check_source.h"
#include "robot/yaml_section.h"

namespace hexapod {
namespace {

// One reading of one file: the names for messages and where problems go.
struct Reading {
  std::string source;
  Problems* problems;
};

std::string at(const std::string& path, std::size_t index) {
  return path + "[" + std::to_string(index) + "]";
}

// The gait entries under `key`, one per position in the leg; names stay empty.
std::vector<JointConfig> readGait(YamlSection& parent, const std::string& path,
                                  const Reading& reading) {
  std::vector<JointConfig> gait;
  for (const YAML::Node& node : parent.list("gait")) {
    YamlSection section(node, at(path, gait.size()), reading.source, *reading.problems);
    JointConfig joint;
    const double signal = section.number("signal", 1.0, kMostSignals, "");
    if (signal != std::floor(signal)) section.addProblem("signal", "should be a whole number.");
    joint.signal = static_cast<Signal>(static_cast<int>(signal));
    joint.neutral_rad = section.number("neutral_rad", -M_PI, M_PI, "rad");
    joint.amplitude_rad = section.number("amplitude_rad", -M_PI, M_PI, "rad");
    section.finish();
    gait.push_back(joint);
  }
  return gait;
}

LegConfig readLeg(YamlSection& section, const std::string& path,
                  const std::vector<JointConfig>& common_gait, const Reading& reading) {
  LegConfig leg;
  leg.name = section.text("name");
  leg.joints = section.has("gait") ? readGait(section, path + ".gait", reading) : common_gait;
  const std::vector<YAML::Node> names = section.list("joints");
  if (!section.has("gait") && common_gait.empty()) {
    section.addProblem("gait", "is missing; expected one here or one for all legs beside legs.");
  }
  section.finish();
  if (names.empty() || leg.joints.empty()) return leg;
  if (names.size() != leg.joints.size()) {
    section.addProblem("joints", "has " + std::to_string(names.size()) + " joints, but its gait " +
                                     std::to_string(leg.joints.size()) +
                                     " entries; expected one entry per joint.");
    leg.joints.resize(names.size());
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool is_text = names[i].IsScalar() && !names[i].Scalar().empty();
    if (!is_text) section.addProblem(at("joints", i), "should be the name of a URDF joint.");
    if (is_text) leg.joints[i].name = names[i].Scalar();
  }
  return leg;
}

std::vector<LegConfig> readLegs(YamlSection& root, const Reading& reading) {
  // Left out where every leg has its own.
  std::vector<JointConfig> common_gait;
  if (root.has("gait")) common_gait = readGait(root, "gait", reading);
  std::vector<LegConfig> legs;
  std::set<std::string> names;
  std::set<std::string> joints;
  for (const YAML::Node& node : root.list("legs")) {
    const std::string path = at("legs", legs.size());
    YamlSection section(node, path, reading.source, *reading.problems);
    LegConfig leg = readLeg(section, path, common_gait, reading);
    if (!leg.name.empty() && !names.insert(leg.name).second) {
      section.addProblem("name", "is " + leg.name + " a second time; give each leg its own name.");
    }
    for (const JointConfig& joint : leg.joints) {
      if (joint.name.empty() || joints.insert(joint.name).second) continue;
      section.addProblem("joints", "lists joint " + joint.name +
                                       " a second time; a joint belongs to one leg, once.");
    }
    legs.push_back(leg);
  }
  return legs;
}

Servo readServo(YamlSection section) {
  Servo servo;
  servo.gain_per_s = section.number("gain_per_s", 0.1, 1000.0, "1/s");
  servo.dead_zone_rad_per_s = section.number("dead_zone_rad_per_s", 0.0, 1.0, "rad/s");
  section.finish();
  return servo;
}

// Reads `value` if the key is there, and tells whether it is.
bool readIfThere(YamlSection& section, const std::string& key, const std::array<double, 2>& range,
                 const std::string& unit, double& value) {
  if (!section.has(key)) return false;
  value = section.number(key, range[0], range[1], unit);
  return true;
}

void readContact(YamlSection section, RobotConfig& config) {
  Contact& contact = config.contact;
  contact.friction = section.number("friction", 0.0, 10.0, "");
  config.has_slip =
      readIfThere(section, "slip_per_n_s", {0.0, 10.0}, "m/(N s)", contact.slip_per_n_s);
  contact.soft_erp = section.number("soft_erp", 0.0, 1.0, "");
  config.has_soft_cfm = readIfThere(section, "soft_cfm", {0.0, 1.0}, "m/(N s)", contact.soft_cfm);
  contact.max_correcting_velocity_m_per_s =
      section.number("max_correcting_velocity_m_per_s", 0.001, 1e6, "m/s");
  contact.joint_erp = section.number("joint_erp", 0.0, 1.0, "");
  contact.joint_cfm = section.number("joint_cfm", 0.0, 1.0, "");
  section.finish();
}

void readFailure(YamlSection section, RobotConfig& config) {
  config.has_max_base_height = readIfThere(section, "max_base_height_m", {0.01, 100.0}, "m",
                                           config.failure.max_base_height_m);
  section.finish();
}

// What calibration found (calibration/calibrated_robot.h); left out where there was none.
void readCalibration(YamlSection& root, RobotScales& scales) {
  if (!root.has("calibration")) return;
  YamlSection section = root.section("calibration");
  scales.friction = section.number("friction_scale", 0.05, 20.0, "");
  scales.servo_gain = section.number("servo_gain_scale", 0.05, 20.0, "");
  scales.torque = section.number("torque_scale", 0.05, 20.0, "");
  scales.mass = section.number("mass_scale", 0.05, 20.0, "");
  section.finish();
}

std::string readForward(YamlSection& root) {
  if (!root.has("forward")) return "x";
  const std::string axis = root.text("forward");
  if (axis == "x" || axis == "y" || axis == "-x" || axis == "-y") return axis;
  root.addProblem("forward", "is \"" + axis + "\"; expected x, y, -x or -y.");
  return "x";
}

}  // namespace

RobotConfig parseRobotConfig(const std::string& text, const std::string& source,
                             Problems& problems) {
  RobotConfig config;
  if (!isReadable(text, source, "YAML", problems)) return config;
  try {
    YamlSection root(YAML::Load(text), "", source, problems);
    config.name = root.text("name");
    config.base_link = root.text("base_link");
    config.forward = readForward(root);
    config.legs = readLegs(root, Reading{source, &problems});
    config.servo = readServo(root.section("servo"));
    readContact(root.section("contact"), config);
    readFailure(root.section("failure"), config);
    readCalibration(root, config.calibration);
    root.finish();
  } catch (const YAML::Exception& error) {
    problems.add(source, "line " + std::to_string(error.mark.line + 1) +
                             ": this is not YAML: " + error.msg + ".");
  }
  return config;
}

}  // namespace hexapod
