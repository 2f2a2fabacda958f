#pragma once

#include "robot/robot_description.h"

namespace hexapod {

/// By how much a robot is otherwise than its files say: found by calibration, or thought of.
struct RobotScales {
  double friction = 1.0;    ///< of Contact::friction
  double servo_gain = 1.0;  ///< of Servo::gain_per_s
  double torque = 1.0;      ///< of every joint's max_torque_nm
  double mass = 1.0;        ///< of every mass and inertia
};

/// Scales a mass and its inertia.
void scaleMass(double scale, Body& body);

/// Applies the scales; the digest stays as it is.
void applyScales(const RobotScales& scales, RobotDescription& robot);

}  // namespace hexapod
