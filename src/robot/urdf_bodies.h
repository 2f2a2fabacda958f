#pragma once

#include <urdf_model/model.h>
#include <urdf_world/types.h>

#include <Eigen/Geometry>
#include <functional>
#include <map>
#include <string>

#include "common/problems.h"
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

/// Where sentences about a file go: what is wrong with it, and what is taken otherwise than it
/// says.
struct Findings {
  const std::string& source;
  Problems& problems;
  Problems& remarks;
};

/// Lumps mass, centre of mass, inertia (parallel axes) and collision shapes of `link` and of the
/// links fixed to it. Masses and inertias are judged on the lump: frames, points and stubs that are
/// part of a sound body are no problem. A cylinder no longer than its diameter becomes bars across
/// it (see addDisc). Adds a problem for a shape that is impossible or of an unknown kind, and for a
/// body without mass or with an impossible inertia.
LumpedBody lumpFixedLinks(const urdf::Link& link, const Findings& findings);

/// Takes a mesh posed in the body's frame; returns what is wrong with it, "" when nothing is.
using TakeMesh = std::function<std::string(const urdf::Mesh&, const Eigen::Isometry3d&)>;

/// The same with somebody who makes something of collision meshes, and who then judges the mass.
LumpedBody lumpFixedLinks(const urdf::Link& link, const Findings& findings, const TakeMesh& take);

/// Whether some solid could have this inertia about its centre of mass, but for the few digits that
/// files give.
bool isPossibleInertia(const Eigen::Matrix3d& inertia);

}  // namespace hexapod
