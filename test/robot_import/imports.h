#pragma once

#include <string>
#include <vector>

#include "robot_import/import_robot.h"

namespace hexapod {

/// Imports for tests, with 200 random gaits.
ImportResult import(const std::string& urdf, const std::string& folder = ".");

/// What an import is refused with; "" when it is not.
std::string complaint(const std::string& urdf);

/// Throws std::runtime_error when there is nothing to replace.
std::string replacedAll(std::string text, const std::string& from, const std::string& to);

/// Without elements of a name and what is in them.
std::string without(std::string urdf, const std::string& element);

bool isRemarked(const ImportResult& result, const std::string& words);

std::vector<std::string> legNames(const RobotDescription& robot);

/// Expects what holds of every robot that is ready: it stands on its feet, level, and is simulated
/// fast.
void expectReady(const ImportResult& result);

}  // namespace hexapod
