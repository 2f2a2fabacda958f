#pragma once

#include "robot_import/imported_robot.h"

namespace hexapod {

/// Remarks on legs that turn about one axis side by side, as the two halves of a linkage do whose
/// ends meet in one foot: a URDF cannot say so, and both are simulated as legs of their own.
/// The legs must have their names.
void remarkLinkages(const ImportedRobot& imported, ImportReport& report);

}  // namespace hexapod
