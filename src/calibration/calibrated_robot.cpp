#include "calibration/calibrated_robot.h"

#include <cmath>
#include <sstream>

#include "common/problems.h"
#include "common/text.h"
#include "robot/robot_config.h"

namespace hexapod {
namespace {

constexpr const char* kComment =
    "# What calibrate found: the values above and those of the URDF are multiplied with it.";

// Without an earlier section and the comment above it.
std::string withoutCalibration(const std::string& text) {
  std::istringstream lines(text);
  std::string kept;
  bool is_inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line == kComment) continue;
    const bool is_indented = !line.empty() && (line[0] == ' ' || line[0] == '\t');
    is_inside = line.rfind("calibration:", 0) == 0 || (is_inside && is_indented);
    if (!is_inside) kept += line + "\n";
  }
  while (kept.size() > 1 && kept.substr(kept.size() - 2) == "\n\n") kept.pop_back();
  return kept;
}

}  // namespace

RobotScales scalesOf(const BodyVector& found) {
  return {std::exp(found[kFriction]), std::exp(found[kServoGain]), std::exp(found[kTorque]),
          std::exp(found[kMass])};
}

std::string calibratedYaml(const std::string& yaml_text, const std::string& source,
                           const RobotScales& found) {
  Problems problems;
  const RobotScales before = parseRobotConfig(yaml_text, source, problems).calibration;
  problems.throwIfAny();
  const auto line = [](const char* name, double scale) {
    return "  " + std::string(name) + ": " + fixedText(scale, 4) + "\n";
  };
  return withoutCalibration(yaml_text) + "\n" + kComment + "\ncalibration:\n" +
         line("friction_scale", before.friction * found.friction) +
         line("servo_gain_scale", before.servo_gain * found.servo_gain) +
         line("torque_scale", before.torque * found.torque) +
         line("mass_scale", before.mass * found.mass);
}

}  // namespace hexapod
