#pragma once

#include "robot/robot_description.h"

namespace hexapod {

/// How large and heavy a robot is, and the constants that depend on it.

constexpr double kGravity_m_per_s2 = 9.81;

/// Whether the radius of gyration about some axis is beyond all of the body's shapes, with room
/// for what they leave out. False without shapes.
bool isAbsurdInertia(const Body& body);

double totalMass_kg(const RobotDescription& robot);

/// Farthest that a point of the leg can be from its first hinge, were all angles free [m].
double reach_m(const Leg& leg);

/// The mean reach of the legs [m].
double legReach_m(const RobotDescription& robot);

/// Leg reach over that of the hexapod the paper's lengths are made for, 0.29 m, in hundredths:
/// what lengths of options and figures are multiplied with to suit the robot.
double lengthScale(const RobotDescription& robot);

/// Slip and softness of a contact [m/(N s)] that give the robot the slip velocity and the
/// penetration under its own weight that the published values give theirs of 3.06 kg.
double slipFor(const RobotDescription& robot);
double softCfmFor(const RobotDescription& robot);

/// Height of the base's origin [m] above which the robot must have been thrown up.
double maxBaseHeightFor(const RobotDescription& robot);

}  // namespace hexapod
