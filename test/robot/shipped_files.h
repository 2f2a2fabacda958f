#pragma once

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "robot/load_robot.h"

namespace hexapod {

inline const char* const kUrdfFile = "urdf/hexapod.urdf";
inline const char* const kYamlFile = "config/hexapod.yaml";

inline std::string contentOf(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("Start this test in the package's root: no " + file);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// The first `from` of a text replaced; throws when there is none, so that no test edits nothing.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("Nothing to replace: " + from);
  return text.replace(at, from.size(), to);
}

/// Names of the two texts in messages.
inline const char* const kUrdf = "r.urdf";
inline const char* const kYaml = "r.yaml";

/// What parseRobot() has to say about the two texts; "" when it accepts them.
inline std::string complaint(const std::string& urdf, const std::string& yaml) {
  try {
    parseRobot(urdf, yaml, kUrdf, kYaml);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

}  // namespace hexapod
