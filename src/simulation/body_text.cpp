#include "simulation/body_text.h"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <vector>

#include "common/text.h"
#include "simulation/physics.h"

namespace hexapod {
namespace {

struct Degree {
  const char* name;
  const char* field;  // of Physics
  double Physics::*value;
};

constexpr std::array<Degree, 8> kDegrees = {{
    {"friction", "friction_scale", &Physics::friction_scale},
    {"mass", "mass_scale", &Physics::mass_scale},
    {"gain", "servo_gain_scale", &Physics::servo_gain_scale},
    {"torque", "torque_scale", &Physics::torque_scale},
    {"slope_x", "slope_x_rad", &Physics::slope_x_rad},
    {"slope_y", "slope_y_rad", &Physics::slope_y_rad},
    {"latency", "command_latency_s", &Physics::command_latency_s},
    {"step", "step_s", &Physics::step_s},
}};

std::vector<std::string> namesOfDegrees() {
  std::vector<std::string> names;
  for (const Degree& degree : kDegrees) names.emplace_back(degree.name);
  return names;
}

const Degree* degreeNamed(const std::string& word) {
  const auto found = std::find_if(kDegrees.begin(), kDegrees.end(), [&](const Degree& degree) {
    return word == degree.name || word == degree.field;
  });
  return found == kDegrees.end() ? nullptr : &*found;
}

double numberOf(const std::string& name, const std::string& text) {
  const std::optional<double> number = doubleFromText(text);
  if (number) return *number;
  throw std::invalid_argument("'" + name + ": " + text +
                              "' has no number after the colon; expected for example '" + name +
                              ": 0.7'.");
}

// Whose leg or what it is, or the sentence with all that it could have been.
void requireLeg(const RobotDescription& robot, const std::string& word) {
  std::vector<std::string> legs;
  for (const Leg& leg : robot.legs) legs.push_back(leg.name);
  if (std::find(legs.begin(), legs.end(), word) != legs.end()) return;
  throw std::invalid_argument("'" + word + "' is nothing of a body; expected a leg (" +
                              listed(legs) + ") or one of " + listed(namesOfDegrees()) + ".");
}

}  // namespace

Physics bodyFromText(const RobotDescription& robot, const std::string& text,
                     const Physics& otherwise) {
  Physics body = otherwise;
  std::string legs;
  for (const std::string& part : separated(text)) {
    if (part == toString(LegCondition::kIntact)) continue;
    const std::size_t colon = part.find(':');
    const std::string word = trimmed(part.substr(0, colon));
    if (colon == std::string::npos) {
      throw std::invalid_argument("'" + part + "' says nothing of a body; expected for example '" +
                                  robot.legs.front().name + ": locked' or 'friction: 0.7'.");
    }
    if (const Degree* degree = degreeNamed(word)) {
      body.*(degree->value) = numberOf(word, trimmed(part.substr(colon + 1)));
      continue;
    }
    requireLeg(robot, word);
    legs += part + ",";
  }
  if (!legs.empty()) body.legs = legStatesFromText(robot, legs);
  checkPhysics(body);
  return body;
}

std::string bodyText(const RobotDescription& robot, const Physics& body, const Physics& otherwise) {
  std::vector<std::string> parts;
  const std::string legs = describeLegs(robot, body.legs);
  if (legs != toString(LegCondition::kIntact)) parts.push_back(legs);
  for (const Degree& degree : kDegrees) {
    const double value = body.*(degree.value);
    if (value == otherwise.*(degree.value)) continue;
    parts.push_back(std::string(degree.name) + ": " + exactText(value));
  }
  return parts.empty() ? toString(LegCondition::kIntact) : listed(parts);
}

}  // namespace hexapod
