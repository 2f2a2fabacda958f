#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "hexapod_repertoire/BodyBelief.h"
#include "robot/robot_description.h"

namespace hexapod {

/// How likely a leg is out of order, in whatever way, by a belief; 0 .. 1.
double probabilityOutOfOrder(const hexapod_repertoire::BodyBelief& belief, const std::string& leg);

/// The robot's body as it is believed to be, in the frame of its base link: a line along each leg
/// in its neutral pose, from green (intact) to red (out of order), and what is believed in words
/// above it. Fixed ids.
visualization_msgs::MarkerArray bodyMarkers(const RobotDescription& robot,
                                            const hexapod_repertoire::BodyBelief& belief);

}  // namespace hexapod
