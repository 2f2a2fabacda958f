#pragma once

#include <urdf_model/model.h>
#include <urdf_world/types.h>

#include <Eigen/Geometry>
#include <map>
#include <string>

#include "robot/problems.h"
#include "robot/robot_description.h"

namespace hexapod {

/// Parses a URDF text with urdfdom, whose console messages become sentences in `problems`.
/// Null when there is a problem. Not to be called from two threads at once: urdfdom's console is
/// global.
urdf::ModelInterfaceSharedPtr parseUrdf(const std::string& text, const std::string& source,
                                        Problems& problems);

Eigen::Isometry3d toIsometry(const urdf::Pose& pose);

/// A link and everything fixed to it as one body in the frame of that link.
struct LumpedBody {
  Body body;
  std::map<std::string, Eigen::Isometry3d> body_from_link;  ///< every link in it, by name
};

/// Lumps mass, centre of mass, inertia (parallel axes) and collision shapes of `link` and of the
/// links fixed to it. Adds a problem for a link whose mass, inertia or shape is impossible or of an
/// unknown kind, and for a body without mass.
LumpedBody lumpFixedLinks(const urdf::Link& link, const std::string& source, Problems& problems);

}  // namespace hexapod
