#pragma once

#include <string>

#include "robot_import/check_robot.h"
#include "robot_import/imported_robot.h"

namespace hexapod {

/// Where a robot comes from and what its owner says about it.
struct ImportRequest {
  std::string urdf_text;
  std::string urdf_name;    ///< for sentences
  std::string urdf_folder;  ///< relative meshes start here
  std::string mesh_path;    ///< folder of meshes or of their package, or ""
  std::string forward;      ///< axis of the base link that points ahead, or "" to guess
  int gaits = 500;          ///< random ones that are tried
};

/// A robot that was imported, as it loads from the two texts, and how it does.
struct ImportResult {
  std::string urdf;
  std::string yaml;
  RobotDescription robot;
  ImportedRobot imported;  ///< with looks, for a picture
  std::vector<std::string> remarks;
  StandingCheck standing;
  RandomGaitsCheck gaits;
  std::string not_mirrored;  ///< why left and right are no mirror images, or ""
  std::string to_change;     ///< the one thing to change before it can learn; "" when ready
};

/// Makes of somebody's URDF what learner and executor need: finds the legs, gives them shapes,
/// masses and a gait, and tries the result in simulation, with smaller strokes where most random
/// gaits fall.
///
/// Throws std::runtime_error with a sentence per problem, all of them at once, for a robot that
/// cannot be simulated: no URDF, no legs, nothing to stand on, torques that cannot carry it.
ImportResult importRobot(const ImportRequest& request);

/// What was found, for people.
std::string reportOf(const ImportResult& result);

}  // namespace hexapod
