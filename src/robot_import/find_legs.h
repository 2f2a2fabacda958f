#pragma once

#include <urdf_world/types.h>

#include <string>
#include <vector>

#include "robot_import/imported_robot.h"
#include "robot_import/tell_legs.h"

namespace hexapod {

/// The link that carries the legs: below world and footprint frames and free joints, or the root.
urdf::LinkSharedPtr findBaseLink(urdf::ModelInterface& model, ImportReport& report);

/// The chains of hinges that start at the base. What moves and is no part of one (antennas, wheels,
/// grippers, suspensions, hinges beyond four of a leg) is made fixed where it is at angle 0, or at
/// the nearest limit, in `model`, with a remark. Adds a problem when there are fewer than three,
/// and for links that close a loop.
std::vector<JointChain> findLegs(urdf::ModelInterface& model, const urdf::LinkSharedPtr& base,
                                 ImportReport& report);

}  // namespace hexapod
