#pragma once

#include <geometry_msgs/Point.h>
#include <std_msgs/ColorRGBA.h>
#include <visualization_msgs/Marker.h>

#include <Eigen/Core>
#include <string>

namespace hexapod {

/// What the markers of this room are made of.

std_msgs::ColorRGBA color(double red, double green, double blue, double alpha = 1.0);

geometry_msgs::Point point(double x_m, double y_m, double z_m);
geometry_msgs::Point point(const Eigen::Vector3d& position_m);

/// A marker at the origin of `frame`, opaque black, with scale.x = scale.y = `width_m`; stamp 0
/// lets rviz take the latest tf.
visualization_msgs::Marker marker(const std::string& frame, const std::string& name, int id,
                                  int type, double width_m);

/// A text of letters `height_m` high that faces who looks at it.
visualization_msgs::Marker textMarker(const std::string& frame, const std::string& name, int id,
                                      const std::string& text, double height_m);

/// The marker, or its deletion where it has too few points: a list without any, or a line of one,
/// is an error in rviz.
visualization_msgs::Marker shown(visualization_msgs::Marker marker);

}  // namespace hexapod
