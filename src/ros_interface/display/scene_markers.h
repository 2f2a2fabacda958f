#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "repertoire/repertoire.h"
#include "robot/robot_description.h"

namespace hexapod {

/// What a repertoire is looked at beside, around the origin of a frame and following it: the
/// outline of the robot in its neutral pose with an arrow forward, the paper's region of interest,
/// the scale of colours, and the repertoire's figures as text. Fixed ids.
visualization_msgs::MarkerArray sceneMarkers(const RobotDescription& robot,
                                             const Repertoire& repertoire,
                                             const std::string& frame);

/// How far beside the origin, to either side, texts stand clear of the repertoire [m].
double roomBeside_m(const RobotDescription& robot);

/// The figures of a repertoire, a line each: entries, candidates tried, sparseness, orientation
/// error, as expected in the world that it was learned in.
std::string figuresOf(const Repertoire& repertoire, const RobotDescription& robot);

}  // namespace hexapod
