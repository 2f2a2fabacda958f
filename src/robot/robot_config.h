#pragma once

#include <string>
#include <vector>

#include "common/problems.h"
#include "robot/robot_description.h"
#include "robot/robot_scales.h"

namespace hexapod {

/// A joint of a leg as the YAML names it.
struct JointConfig {
  std::string name;
  Signal signal = Signal::kFirst;
  double neutral_rad = 0.0;
  double amplitude_rad = 0.0;
};

struct LegConfig {
  std::string name;
  std::vector<JointConfig> joints;  ///< from the base outwards
};

/// What the YAML adds to the URDF; config/hexapod.yaml explains the keys. What is not there is
/// derived from the robot (dimensions.h).
struct RobotConfig {
  std::string name;
  std::string base_link;
  std::string forward = "x";    ///< axis of the base link that points forward: x, y, -x or -y
  std::vector<LegConfig> legs;  ///< in genome order
  Servo servo;
  Contact contact;
  FailureRules failure;
  RobotScales calibration;  ///< applied to all that the files say
  bool has_slip = false;
  bool has_soft_cfm = false;
  bool has_max_base_height = false;
};

/// Reads the YAML strictly. Everything wrong is added to `problems`; the result is then incomplete.
RobotConfig parseRobotConfig(const std::string& text, const std::string& source,
                             Problems& problems);

}  // namespace hexapod
