#include "ros_interface/display/marker_parts.h"

#include <cstddef>

namespace hexapod {

using visualization_msgs::Marker;

std_msgs::ColorRGBA color(double red, double green, double blue, double alpha) {
  std_msgs::ColorRGBA result;
  result.r = static_cast<float>(red);
  result.g = static_cast<float>(green);
  result.b = static_cast<float>(blue);
  result.a = static_cast<float>(alpha);
  return result;
}

geometry_msgs::Point point(double x_m, double y_m, double z_m) {
  geometry_msgs::Point result;
  result.x = x_m;
  result.y = y_m;
  result.z = z_m;
  return result;
}

geometry_msgs::Point point(const Eigen::Vector3d& position_m) {
  return point(position_m.x(), position_m.y(), position_m.z());
}

Marker marker(const std::string& frame, const std::string& name, int id, int type, double width_m) {
  Marker result;
  result.header.frame_id = frame;
  result.ns = name;
  result.id = id;
  result.type = type;
  result.pose.orientation.w = 1.0;
  result.scale.x = width_m;
  result.scale.y = width_m;
  result.color.a = 1.0;
  return result;
}

Marker textMarker(const std::string& frame, const std::string& name, int id,
                  const std::string& text, double height_m) {
  Marker result = marker(frame, name, id, Marker::TEXT_VIEW_FACING, 0.0);
  result.scale.z = height_m;
  result.text = text;
  if (text.empty()) result.action = Marker::DELETE;
  return result;
}

Marker shown(Marker marker) {
  const std::size_t fewest = marker.type == Marker::LINE_STRIP ? 2 : 1;
  if (marker.points.size() < fewest) marker.action = Marker::DELETE;
  return marker;
}

}  // namespace hexapod
