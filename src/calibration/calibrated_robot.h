#pragma once

#include <string>

#include "robot/robot_scales.h"
#include "self_model/body.h"

namespace hexapod {

/// The scales that a fit found, the floor's slopes left out.
RobotScales scalesOf(const BodyVector& found);

/// The text of a robot's YAML with the section `calibration` of what was found on top of what the
/// text has there already; all else stays as it is. Throws std::runtime_error when the text is no
/// robot's; `source` stands for it in messages.
std::string calibratedYaml(const std::string& yaml_text, const std::string& source,
                           const RobotScales& found);

}  // namespace hexapod
