#pragma once

#include "geometry/pose2.h"

namespace hexapod {

/// The circular arc from the origin through a point, centred on the lateral (y) axis: the
/// trajectory the paper asks of every behaviour (Cully & Mouret 2013, figure 2A and 2B).
///
/// It leaves the origin along +x (forward) or -x (backward: the point has x < 0) and carries its
/// curvature, never its radius: a straight line has one, 0. The origin itself has no arc; for it
/// curvature, heading and length are 0.
struct Arc {
  double curvature_per_m = 0.0;  ///< signed [1/m]: centre at y = 1/curvature, left when positive
  double heading_rad = 0.0;      ///< heading of the tangent at the end point, in (-pi, pi]
  double length_m = 0.0;         ///< travelled along the arc, signed: negative when backward

  /// Pose on the arc after `fraction` (0 .. 1) of its length, heading along the tangent.
  Pose2 at(double fraction) const;
};

/// The arc through (x_m, y_m): curvature 2y / (x^2 + y^2), heading 2 atan2(y, x) for forward and
/// 2 atan2(-y, -x) for backward arcs, which is the same angle once wrapped.
/// A point on the lateral axis (x = 0) is half a circle away, taken forward.
Arc arcThrough(double x_m, double y_m);

/// theta of the paper's eq. 2: angle between the heading of the end pose and the tangent of the arc
/// through its position, 0 .. pi [rad]. Defined by the actual end point. At the origin: |yaw|.
double orientationError(const Pose2& start_from_end);

}  // namespace hexapod
