#pragma once

#include "robot_import/imported_robot.h"

namespace hexapod {

/// Gives every body the shapes that both engines simulate, and says what was changed: meshes become
/// boxes (base) or capsules (legs), boxes on legs capsules, shapes inside others are dropped, many
/// become one. A body without collision shape gets one of what it looks like. Adds a problem for a
/// base or a leg of which there is nothing.
void shapeBodies(ImportedRobot& imported, ImportReport& report);

/// Legs must not touch in the neutral pose: makes shapes of legs that do thinner, and drops those
/// that touch even so, with a remark.
void separateLegs(ImportedRobot& imported, ImportReport& report);

}  // namespace hexapod
