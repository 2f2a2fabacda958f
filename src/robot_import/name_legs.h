#pragma once

#include <string>

#include "robot_import/imported_robot.h"

namespace hexapod {

/// Guesses which axis of the base link points forward: where names tell front from rear or left
/// from right, they; otherwise the places of the hips. Sets `forward` and `forward_reason`.
void guessForward(ImportedRobot& imported);

/// Orders the legs as the genome has them, counter-clockwise seen from above from the left rear one
/// to the right rear one, and names them: left_rear, left_middle, ... With four or more on a side
/// they are numbered from the front; one on the axis of symmetry is just front or rear.
/// `imported.forward` must be set. Moves the extras along.
void nameLegs(ImportedRobot& imported);

}  // namespace hexapod
