#pragma once

#include <string>

#include "robot_import/imported_robot.h"

namespace hexapod {

/// The robot as a URDF of primitives: base, legs and the frames fixed to them, looks as they were
/// (meshes by the path where they were found). `urdf_name`: what it was made from.
std::string urdfOf(const ImportedRobot& imported, const std::string& urdf_name);

/// The YAML that goes with it, with what each key means.
std::string yamlOf(const ImportedRobot& imported, const std::string& urdf_name);

}  // namespace hexapod
