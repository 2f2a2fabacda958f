#pragma once

#include "robot/urdf_bodies.h"

namespace hexapod {

/// Fills axis, limits, torque and velocity of `joint` from the URDF. A continuous joint, and limits
/// beyond +-pi, are taken as +-pi, with a remark. Adds a problem for what is no hinge or no servo.
void readHinge(const urdf::Joint& from, const Findings& findings, Joint& joint);

}  // namespace hexapod
