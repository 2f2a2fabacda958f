#pragma once

#include "robot_import/find_legs.h"
#include "robot_import/imported_robot.h"

namespace hexapod {

/// Bodies and hinges of base and legs as the URDF has them, with what they look like and the points
/// of their meshes; masses, shapes and torques may be missing or absurd. Limits that are missing
/// are taken as +-pi/2, a velocity as 2 pi rad/s, with a remark. A mesh that is not found or cannot
/// be read is a problem only where it is all there is of a shape.
ImportedRobot buildBodies(const urdf::ModelInterface& model, const urdf::LinkSharedPtr& base,
                          const std::vector<JointChain>& legs, const MeshFiles& files,
                          ImportReport& report);

}  // namespace hexapod
