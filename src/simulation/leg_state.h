#pragma once

#include <string>
#include <vector>

#include "robot/robot_description.h"

namespace hexapod {

/// What can be wrong with a leg. The numbers are those of srv/Disturb.srv.
enum class LegCondition {
  kIntact = 0,
  kLocked = 1,  ///< its servos hold one angle, whatever is commanded
  kLifted = 2,  ///< the same, locked up: see liftedAngles()
  kLimp = 3,    ///< its servos are without power; gears and friction resist a little
  kMissing = 4  ///< it is not there: no mass, no shape
};

/// One leg of a body.
///
/// Legs pass through each other in simulation; that they touch is a verdict, and one on driven
/// legs: servos that push against each other. A limp leg is pushed aside with the little torque
/// that its gears resist with, so that its touch is no failure, and a missing one touches nothing.
struct LegState {
  LegCondition condition = LegCondition::kIntact;
  std::vector<double> locked_rad;  ///< kLocked: one angle per joint; empty: the neutral pose

  bool isDriven() const {
    return condition != LegCondition::kLimp && condition != LegCondition::kMissing;
  }
};

bool operator==(const LegState& a, const LegState& b);
inline bool operator!=(const LegState& a, const LegState& b) { return !(a == b); }

/// The names of the conditions in their order: intact, locked, lifted, limp, missing.
const std::vector<std::string>& legConditionNames();

/// One of legConditionNames().
std::string toString(LegCondition condition);

/// The angles [rad] at which a leg is locked up: joints of the first signal in their neutral pose,
/// those of the second at the end of their swing that takes the leg's lowest point higher.
std::vector<double> liftedAngles(const RobotDescription& robot, std::size_t leg);

/// The angles [rad] that a leg in this state holds whatever is commanded; empty when it follows
/// commands or nothing. (A missing leg's stump holds the neutral pose.)
std::vector<double> heldAngles(const RobotDescription& robot, std::size_t leg,
                               const LegState& state);

/// Legs from text as in "left_middle: locked, right_rear: limp": one state per leg of the robot,
/// the others intact; empty text: an empty list, which means all intact. Throws
/// std::invalid_argument naming the word that is no leg or no condition, and those there are.
std::vector<LegState> legStatesFromText(const RobotDescription& robot, const std::string& text);

/// The same text from the states: "left_middle: locked"; "intact" when nothing is wrong.
std::string describeLegs(const RobotDescription& robot, const std::vector<LegState>& legs);

}  // namespace hexapod
