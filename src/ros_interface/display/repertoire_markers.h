#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "repertoire/repertoire.h"

namespace hexapod {

/// Colour of an orientation error, as in the pictures: from green at 0 through blue to dark violet
/// at 10 degrees and above, darker and darker for those who do not see colours.
std_msgs::ColorRGBA errorColor(double orientation_error_rad);

/// The repertoire around the origin of a frame, as figure 3 of the paper: a disc per end pose
/// coloured by orientation error, a solid needle along the final heading, a dashed dark one along
/// the arc's tangent; entries that may not be used are grey. All are smaller where there are so
/// many that they would hide each other. Three lists of triangles, which rviz draws fast even
/// without a graphics card, with fixed ids. They follow the frame; stamp 0 lets rviz take the
/// latest tf.
visualization_msgs::MarkerArray repertoireMarkers(const Repertoire& repertoire,
                                                  const std::string& frame);

}  // namespace hexapod
