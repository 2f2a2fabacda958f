#pragma once

#include <urdf_model/link.h>

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "common/problems.h"
#include "robot/robot_description.h"
#include "robot_import/fit_shape.h"
#include "robot_import/mesh.h"

namespace hexapod {

/// What a URDF's link looks like, posed in the frame of its body.
struct Look {
  urdf::GeometrySharedPtr geometry;
  Eigen::Isometry3d body_from_look = Eigen::Isometry3d::Identity();
  Mesh mesh;  ///< of a mesh that could be read, in its own frame
};

/// A link that is fixed to a body and not the body's own.
struct Frame {
  std::string link;
  Eigen::Isometry3d body_from_link = Eigen::Isometry3d::Identity();
};

/// What a body has beside what is simulated of it.
struct BodyExtras {
  std::vector<Look> looks;
  std::vector<Frame> frames;
  Points collision_points;  ///< of collision meshes, in the body's frame
  std::size_t meshes = 0;
  std::size_t lost_meshes = 0;  ///< of either kind, that could not be read
};

/// A robot on its way from somebody's URDF to a description. Bodies and joints are in the axes of
/// the URDF's base link until finish() of the import turns x forward.
struct ImportedRobot {
  RobotDescription robot;
  std::vector<BodyExtras> extras;  ///< in the order of bodies(): the base first
  std::string forward = "x";       ///< axis of the base link
  std::string forward_reason;      ///< what it was chosen by
};

/// What an import has to say: what is impossible, and what was changed, a sentence per kind.
struct ImportReport {
  std::string source;  ///< name of the URDF, for sentences
  Problems problems;
  Problems remarks;
};

/// Shapes and extras go by body; calls use(Body&, BodyExtras&, bool is_last_of_leg, bool is_base).
template <typename Use>
void forEachBody(ImportedRobot& imported, const Use& use) {
  use(imported.robot.base, imported.extras[0], false, true);
  std::size_t b = 1;
  for (Leg& leg : imported.robot.legs) {
    for (Segment& segment : leg.segments) {
      use(segment.body, imported.extras[b++], &segment == &leg.segments.back(), false);
    }
  }
}

}  // namespace hexapod
