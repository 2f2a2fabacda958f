#pragma once

#include "robot_import/imported_robot.h"

namespace hexapod {

/// Gives bodies whose meshes could not be read, and legs that have masses but no shapes at all,
/// rods from joint to joint and the base a plate between the hips, with remarks.
void guessShapes(ImportedRobot& imported, ImportReport& report);

}  // namespace hexapod
