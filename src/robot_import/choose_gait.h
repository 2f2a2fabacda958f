#pragma once

#include "robot_import/imported_robot.h"

namespace hexapod {

/// Chooses the neutral pose and how the two signals move each joint, from limits, torques and
/// kinematics alone, and writes them into the joints.
///
/// Every leg looks over a grid of poses and all ways to share its joints between the signals: the
/// first is to move the foot along the ground, ahead rather than to the side, the second up and
/// down; both as a combination of joints that moves it that way and no other (so a femur lifts with
/// the tibia turning against it, and the tibia stays upright). A pose is good when both work within
/// limits and velocities, when the torques bear half of the robot on two legs' share with room,
/// when the tibia is upright, the foot outside of the hip, the belly free, and nothing of the leg
/// but the foot near the floor. All feet come to the same height, and legs that are mirror images
/// move as such.
///
/// `scale` multiplies stroke and lift, 1 being those of the paper's hexapod relative to the reach.
/// Adds a problem where no pose bears the robot. Torques of 0 are first taken as such that the
/// robot is as strong for its size as the paper's, with a remark.
void chooseGait(ImportedRobot& imported, double scale, ImportReport& report);

}  // namespace hexapod
