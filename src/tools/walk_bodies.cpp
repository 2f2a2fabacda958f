#include "tools/walk_bodies.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace hexapod {
namespace {

TrueBody withLegs(const RobotDescription& robot, const std::string& legs) {
  TrueBody body;
  body.name = legs.empty() ? "intact" : legs;
  std::replace(body.name.begin(), body.name.end(), ',', ' ');
  body.physics.legs = legStatesFromText(robot, legs);
  return body;
}

TrueBody slope(const std::string& name, double x_rad, double y_rad) {
  TrueBody body;
  body.name = name;
  body.physics.slope_x_rad = x_rad;
  body.physics.slope_y_rad = y_rad;
  return body;
}

TrueBody scaled(const std::string& name, double Physics::*value, double scale) {
  TrueBody body;
  body.name = name;
  body.physics.*value = scale;
  return body;
}

}  // namespace

std::vector<std::string> splitList(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const std::size_t first = part.find_first_not_of(' ');
    if (first == std::string::npos) continue;
    words.push_back(part.substr(first, part.find_last_not_of(' ') - first + 1));
  }
  return words;
}

std::vector<TrueBody> campaignBodies(const RobotDescription& robot) {
  std::vector<TrueBody> bodies = {withLegs(robot, "")};
  const std::size_t legs = robot.legs.size();
  const auto leg = [&](std::size_t i) { return robot.legs[i % legs].name; };
  for (std::size_t i = 0; i < legs; ++i) bodies.push_back(withLegs(robot, leg(i) + ": lifted"));
  for (const std::string condition : {"locked", "missing", "limp"}) {
    for (std::size_t i = 0; i < 3; ++i) {
      bodies.push_back(withLegs(robot, leg(i) + ": " + condition));
    }
  }
  bodies.push_back(withLegs(robot, leg(1) + ": lifted, " + leg(4) + ": lifted"));
  TrueBody tired = withLegs(robot, leg(2) + ": lifted");
  tired.name += "  friction x 0.75  gain x 0.9";
  tired.physics.friction_scale = 0.75;
  tired.physics.servo_gain_scale = 0.9;
  bodies.push_back(tired);
  TrueBody slippery = scaled("friction x 0.6  mass x 1.1", &Physics::friction_scale, 0.6);
  slippery.physics.mass_scale = 1.1;
  bodies.push_back(slippery);
  bodies.push_back(scaled("torque x 0.8", &Physics::torque_scale, 0.8));
  bodies.push_back(scaled("gain x 0.7", &Physics::servo_gain_scale, 0.7));
  bodies.push_back(scaled("3 ms step", &Physics::step_s, 0.003));
  bodies.push_back(slope("slope 0.05 along x", 0.05, 0.0));
  bodies.push_back(slope("slope 0.05 along y", 0.0, 0.05));
  bodies.push_back(slope("slope 0.05 at 225 degrees", -0.03536, -0.03536));
  return bodies;
}

std::vector<TrueBody> bodiesFromText(const RobotDescription& robot, const std::string& text) {
  const std::vector<TrueBody> all = campaignBodies(robot);
  if (text == "all") return all;
  std::vector<TrueBody> chosen;
  std::string names;
  for (const TrueBody& body : all) names += (names.empty() ? "" : ", ") + body.name;
  for (const std::string& word : splitList(text)) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const TrueBody& body) { return body.name == word; });
    if (found != all.end()) {
      chosen.push_back(*found);
    } else if (word.find(':') != std::string::npos) {
      chosen.push_back(withLegs(robot, word));
    } else {
      throw std::invalid_argument("There is no body '" + word + "'; expected all, legs as in '" +
                                  robot.legs.front().name + ": limp', or of " + names + ".");
    }
  }
  return chosen;
}

}  // namespace hexapod
