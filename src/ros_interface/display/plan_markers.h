#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "geometry/pose2.h"

namespace hexapod {

/// What the plan markers show, all in one frame.
struct PlanPicture {
  std::string frame;
  std::vector<Pose2> path;    ///< dense, along the arcs
  std::vector<Pose2> stops;   ///< pose predicted after each behaviour
  std::vector<Pose2> walked;  ///< poses measured after each behaviour so far
  Pose2 goal;
  double xy_tolerance_m = 0.0;
};

/// The plan as a line, its stops as points with headings, the goal as a ring with an arrow, the
/// walked poses as a trail. Fixed ids.
visualization_msgs::MarkerArray planMarkers(const PlanPicture& picture);

}  // namespace hexapod
