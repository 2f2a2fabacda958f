#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <optional>
#include <string>
#include <vector>

#include "geometry/footprint.h"
#include "geometry/pose2.h"

namespace hexapod {

/// A behaviour that was walked.
struct Miss {
  Pose2 predicted;
  Pose2 reached;
};

/// What the plan markers show, all in one frame.
struct PlanPicture {
  std::string frame;
  std::vector<Pose2> path;    ///< dense, along the arcs
  std::vector<Pose2> stops;   ///< pose predicted after each behaviour
  std::vector<Pose2> walked;  ///< poses measured at rest: the start, then after each behaviour
  std::vector<Miss> misses;   ///< of those behaviours that were played as they are
  Pose2 goal;
  double xy_tolerance_m = 0.0;
};

/// The plan as a line with its stops as points with headings, numbered on from the behaviours
/// walked; those as a trail of arcs from stop to stop, and a line from where each was predicted to
/// end; the goal as a ring with an arrow. Takes the place of all that was shown before.
visualization_msgs::MarkerArray planMarkers(const PlanPicture& picture);

/// A goal that is not walked to.
struct RefusedGoal {
  std::string frame;
  Pose2 goal;
  double xy_tolerance_m = 0.0;
  std::string reason;            ///< a sentence
  std::optional<Pose2> nearest;  ///< that can be reached, if one was looked for
};

/// The rim of what the robot may cover, whatever its legs do, in the frame of its footprint; moves
/// along with it.
visualization_msgs::Marker footprintMarker(const Footprint& footprint, const std::string& frame);

/// The goal in red with its reason, the nearest pose in blue; beside what is shown.
visualization_msgs::MarkerArray refusedMarkers(const RefusedGoal& refused);

}  // namespace hexapod
