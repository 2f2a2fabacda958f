#pragma once

#include "geometry/pose2.h"

namespace hexapod {

/// How far apart two poses are: by their positions and, where headings count, by those, too.
struct PoseMetric {
  double heading_m_per_rad = 0.0;  ///< what a radian between headings counts, >= 0; 0: nothing

  /// Square of the distance [m^2].
  double squaredDistance_m2(const Pose2& a, const Pose2& b) const {
    const double dx = a.x_m - b.x_m;
    const double dy = a.y_m - b.y_m;
    if (heading_m_per_rad == 0.0) return dx * dx + dy * dy;
    const double turn_m = heading_m_per_rad * headingDistance(a, b);
    return dx * dx + dy * dy + turn_m * turn_m;
  }
};

}  // namespace hexapod
