#pragma once

#include <string>

#include "robot/robot_description.h"
#include "simulation/world.h"

namespace hexapod {

/// A body as users write it: legs with their conditions (leg_state.h), and by degrees friction,
/// mass, gain and torque as scales, slope_x and slope_y [rad], latency and step [s], as in
/// "left_middle: limp, friction: 0.7"; the longer names of the fields of Physics will do as well.
///
/// What the text does not name is as in `otherwise`. Throws std::invalid_argument with a sentence
/// that names the word that is wrong, and what was expected.
Physics bodyFromText(const RobotDescription& robot, const std::string& text,
                     const Physics& otherwise = {});

/// The text for what of `body` is not as in `otherwise`, which bodyFromText() reads back; "intact"
/// when nothing is. (Angles at which a leg is locked are not told, nor torques of single joints.)
std::string bodyText(const RobotDescription& robot, const Physics& body,
                     const Physics& otherwise = {});

}  // namespace hexapod
