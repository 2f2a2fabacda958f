#pragma once

#include <urdf_model/model.h>

#include <string>

#include "common/problems.h"
#include "robot/robot_config.h"
#include "robot/robot_description.h"

namespace hexapod {

/// A robot's URDF and YAML, read without problems, and the names of the files for messages.
struct RobotSources {
  const urdf::ModelInterface& model;
  const RobotConfig& config;
  std::string urdf_name;
  std::string yaml_name;
};

/// Joins the two into a description without digest. What does not fit (see loadRobot()) is added to
/// `problems`; the result is then incomplete.
RobotDescription assembleRobot(const RobotSources& sources, Problems& problems);

/// Turns the frame of the base, and so all that is given in it, so that `axis` of the base link (x,
/// y, -x or -y) becomes x.
void turnForward(const std::string& axis, RobotDescription& robot);

}  // namespace hexapod
