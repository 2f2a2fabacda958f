#include "tools/walk_bodies.h"

#include <sstream>
#include <stdexcept>

#include "simulation/body_text.h"

namespace hexapod {

std::vector<std::string> splitList(const std::string& text, char separator) {
  std::vector<std::string> words;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, separator);) {
    const std::size_t first = part.find_first_not_of(' ');
    if (first == std::string::npos) continue;
    words.push_back(part.substr(first, part.find_last_not_of(' ') - first + 1));
  }
  return words;
}

std::vector<std::string> campaignBodies(const RobotDescription& robot) {
  std::vector<std::string> bodies = {"intact"};
  const std::size_t legs = robot.legs.size();
  const auto leg = [&](std::size_t i) { return robot.legs[i % legs].name; };
  for (std::size_t i = 0; i < legs; ++i) bodies.push_back(leg(i) + ": lifted");
  for (const std::string condition : {"locked", "missing", "limp"}) {
    for (std::size_t i = 0; i < 3; ++i) bodies.push_back(leg(i) + ": " + condition);
  }
  bodies.push_back(leg(1) + ": lifted, " + leg(4) + ": lifted");
  bodies.push_back(leg(2) + ": lifted, friction: 0.75, gain: 0.9");
  for (const char* otherwise :
       {"friction: 0.6, mass: 1.1", "torque: 0.8", "gain: 0.7", "step: 0.003", "slope_x: 0.05",
        "slope_y: 0.05", "slope_x: -0.03536, slope_y: -0.03536"}) {
    bodies.emplace_back(otherwise);
  }
  return bodies;
}

std::vector<TrueBody> bodiesFromText(const RobotDescription& robot, const std::string& text) {
  std::vector<TrueBody> bodies;
  for (const std::string& one : text == "all" ? campaignBodies(robot) : splitList(text, ';')) {
    bodies.push_back({one, bodyFromText(robot, one)});
  }
  if (!bodies.empty()) return bodies;
  throw std::invalid_argument("'" + text + "' names no body; expected all, or bodies with " +
                              "semicolons between them, as in 'intact; " + robot.legs.front().name +
                              ": limp, friction: 0.7'.");
}

}  // namespace hexapod
