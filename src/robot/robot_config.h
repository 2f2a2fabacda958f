#pragma once

#include <string>
#include <vector>

#include "robot/problems.h"
#include "robot/robot_description.h"

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

/// What the YAML adds to the URDF; config/hexapod.yaml explains the keys.
struct RobotConfig {
  std::string name;
  std::string base_link;
  std::vector<LegConfig> legs;  ///< in genome order
  Servo servo;
  Contact contact;
  FailureRules failure;
};

/// Reads the YAML strictly. Everything wrong is added to `problems`; the result is then incomplete.
RobotConfig parseRobotConfig(const std::string& text, const std::string& source,
                             Problems& problems);

}  // namespace hexapod
