#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "geometry/pose2.h"
#include "robot/robot_description.h"
#include "simulation/recording.h"

namespace hexapod {

/// When each foot of a robot stood while a behaviour was played.
struct GaitPicture {
  std::string title;
  std::vector<std::string> legs;
  std::vector<std::vector<bool>> stands;  ///< one row per command, one value per leg
  double period_s = 0.0;                  ///< of commands
};

GaitPicture gaitOf(const RobotDescription& robot, const Recording& recording, double period_s);

/// The gait diagram: a dark bar along a leg's row while its foot stands, time from left to right as
/// one looks along `frame_from_corner`'s x, whose origin is the upper left corner. Fixed ids.
visualization_msgs::MarkerArray gaitMarkers(const GaitPicture& picture, const std::string& frame,
                                            const Pose2& frame_from_corner);

/// What takes away the diagram of a robot of so many legs.
visualization_msgs::MarkerArray noGaitMarkers(std::size_t legs, const std::string& frame);

}  // namespace hexapod
