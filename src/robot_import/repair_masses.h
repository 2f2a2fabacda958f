#pragma once

#include "robot_import/imported_robot.h"

namespace hexapod {

/// Masses from the shapes where there are none, inertias where they are missing or absurd, and at
/// least a thousandth of the robot's mass for every body; with remarks.
void repairMasses(ImportedRobot& imported, ImportReport& report);

}  // namespace hexapod
