#include "simulation/leg_state.h"

#include <algorithm>
#include <stdexcept>

#include "common/text.h"
#include "simulation/kinematics.h"

namespace hexapod {
namespace {

std::vector<std::string> legNames(const RobotDescription& robot) {
  std::vector<std::string> names;
  for (const Leg& leg : robot.legs) names.push_back(leg.name);
  return names;
}

// Index of `word`, or a sentence about what it should have been.
std::size_t indexOf(const std::string& word, const std::vector<std::string>& words,
                    const std::string& what) {
  const auto found = std::find(words.begin(), words.end(), word);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  throw std::invalid_argument("'" + word + "' is no " + what + "; expected one of " +
                              listed(words) + ".");
}

// Angles of the leg with its second signal at `signal`, in the order of its joints.
std::vector<double> swungTo(const Leg& leg, double signal) {
  std::vector<double> angles_rad;
  for (const Segment& segment : leg.segments) {
    const Joint& joint = segment.joint;
    const double swing = joint.signal == Signal::kSecond ? signal : 0.0;
    angles_rad.push_back(std::clamp(joint.neutral_rad + swing * joint.amplitude_rad,
                                    joint.lower_rad, joint.upper_rad));
  }
  return angles_rad;
}

double lowestPointOfLeg(const RobotDescription& robot, std::size_t index,
                        const std::vector<double>& leg_angles_rad) {
  std::size_t first = 0;
  for (std::size_t i = 0; i < index; ++i) first += robot.legs[i].segments.size();
  std::vector<double> angles_rad = robot.neutralPose();
  std::copy(leg_angles_rad.begin(), leg_angles_rad.end(), angles_rad.data() + first);
  const std::vector<Eigen::Isometry3d> base_from_bodies = baseFromBodies(robot, angles_rad);
  double lowest_m = 1e3;
  for (std::size_t s = 0; s < leg_angles_rad.size(); ++s) {
    for (const Shape& shape : robot.legs[index].segments[s].body.shapes) {
      lowest_m = std::min(
          lowest_m, lowestPoint(shape, base_from_bodies[1 + first + s] * shape.body_from_shape));
    }
  }
  return lowest_m;
}

}  // namespace

bool operator==(const LegState& a, const LegState& b) {
  return a.condition == b.condition && a.locked_rad == b.locked_rad;
}

const std::vector<std::string>& legConditionNames() {
  static const std::vector<std::string> names = {"intact", "locked", "lifted", "limp", "missing"};
  return names;
}

std::string toString(LegCondition condition) {
  return legConditionNames()[static_cast<std::size_t>(condition)];
}

std::vector<double> liftedAngles(const RobotDescription& robot, std::size_t leg) {
  const std::vector<double> up = swungTo(robot.legs[leg], 1.0);
  const std::vector<double> down = swungTo(robot.legs[leg], -1.0);
  return lowestPointOfLeg(robot, leg, up) >= lowestPointOfLeg(robot, leg, down) ? up : down;
}

std::vector<double> heldAngles(const RobotDescription& robot, std::size_t leg,
                               const LegState& state) {
  switch (state.condition) {
    case LegCondition::kLocked:
      if (!state.locked_rad.empty()) return state.locked_rad;
      break;
    case LegCondition::kLifted:
      return liftedAngles(robot, leg);
    case LegCondition::kMissing:
      break;
    case LegCondition::kIntact:
    case LegCondition::kLimp:
      return {};
  }
  return swungTo(robot.legs[leg], 0.0);
}

std::vector<LegState> legStatesFromText(const RobotDescription& robot, const std::string& text) {
  std::vector<LegState> legs;
  for (const std::string& part : separated(text)) {
    const std::size_t colon = part.find(':');
    if (colon == std::string::npos) {
      throw std::invalid_argument("'" + part + "' is no leg and condition; expected for example '" +
                                  robot.legs.front().name + ": locked'.");
    }
    legs.resize(robot.legs.size());
    LegState& leg = legs[indexOf(trimmed(part.substr(0, colon)), legNames(robot), "leg")];
    leg.condition = static_cast<LegCondition>(
        indexOf(trimmed(part.substr(colon + 1)), legConditionNames(), "condition of a leg"));
  }
  return legs;
}

std::string describeLegs(const RobotDescription& robot, const std::vector<LegState>& legs) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (legs[i].condition == LegCondition::kIntact) continue;
    parts.push_back(robot.legs[i].name + ": " + toString(legs[i].condition));
  }
  return parts.empty() ? toString(LegCondition::kIntact) : listed(parts);
}

}  // namespace hexapod
