#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "geometry/pose2.h"
#include "repertoire/repertoire.h"

namespace hexapod {

/// Colour of an orientation error, as in the pictures: from green at 0 through blue to dark violet
/// at 10 degrees and above, darker and darker for those who do not see colours.
std_msgs::ColorRGBA errorColor(double orientation_error_rad);

/// The repertoire around the origin of a frame, as figure 3 of the paper: a disc per end pose
/// coloured by orientation error, a line along the final heading, a dashed dark one along the arc's
/// tangent; entries that may not be used are grey. Three list markers with fixed ids, whatever the
/// number of entries. They follow the frame; stamp 0 lets rviz take the latest tf.
visualization_msgs::MarkerArray repertoireMarkers(const Repertoire& repertoire,
                                                  const std::string& frame);

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
