#pragma once

#include <string>

#include "robot/robot_description.h"

namespace hexapod {

/// Reads a robot from its URDF (bodies, joints, limits) and its YAML (legs, gait, servo, contact;
/// config/hexapod.yaml documents every key).
///
/// Throws std::runtime_error with a sentence per problem, all of them at once, each naming file,
/// link, joint or key, what was expected, what was found and what to do: file missing or not XML or
/// YAML, unknown or missing key, wrong type or range, joint not in the URDF, not a hinge, without
/// limits, not in the chain from base_link, link without mass or with an impossible inertia,
/// unknown collision shape.
/// Not to be called from two threads at once (urdfdom's console is global).
RobotDescription loadRobot(const std::string& urdf_file, const std::string& yaml_file);

/// The same from texts; `urdf_name` and `yaml_name` stand for the files in messages.
RobotDescription parseRobot(const std::string& urdf_text, const std::string& yaml_text,
                            const std::string& urdf_name, const std::string& yaml_name);

}  // namespace hexapod
