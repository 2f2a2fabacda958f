#include "ros_interface/display/body_markers.h"

#include <algorithm>
#include <cstddef>

#include "simulation/kinematics.h"

namespace hexapod {
namespace {

using visualization_msgs::Marker;

constexpr double kWidth_m = 0.02;
constexpr double kTextAbove_m = 0.2;
constexpr double kTextHeight_m = 0.04;

geometry_msgs::Point point(const Eigen::Vector3d& position_m) {
  geometry_msgs::Point result;
  result.x = position_m.x();
  result.y = position_m.y();
  result.z = position_m.z();
  return result;
}

Marker marker(const RobotDescription& robot, const std::string& name, std::size_t id, int type) {
  Marker result;
  result.header.frame_id = robot.base_link;
  result.ns = name;
  result.id = static_cast<int>(id);
  result.type = type;
  result.pose.orientation.w = 1.0;
  result.frame_locked = true;
  return result;
}

// From the hip to the foot; the tip of the last segment is about twice as far as its middle.
Marker lineOfLeg(const RobotDescription& robot, std::size_t leg, std::size_t first_body) {
  const std::vector<Eigen::Isometry3d> poses = baseFromBodies(robot, robot.neutralPose());
  const Eigen::AngleAxisd link_from_base(robot.link_from_base_yaw_rad, Eigen::Vector3d::UnitZ());
  Marker line = marker(robot, "believed_legs", leg, Marker::LINE_STRIP);
  line.scale.x = kWidth_m;
  const std::vector<Segment>& segments = robot.legs[leg].segments;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    line.points.push_back(point(link_from_base * poses[first_body + k].translation()));
  }
  const Eigen::Vector3d tip =
      poses[first_body + segments.size() - 1] * (2.0 * segments.back().body.center_of_mass_m);
  line.points.push_back(point(link_from_base * tip));
  return line;
}

}  // namespace

double probabilityOutOfOrder(const hexapod_repertoire::BodyBelief& belief, const std::string& leg) {
  double probability = 0.0;
  for (std::size_t i = 0; i < std::min(belief.bodies.size(), belief.probabilities.size()); ++i) {
    // "left_middle: lifted, right_middle: limp"
    const std::string body = ", " + belief.bodies[i];
    if (body.find(", " + leg + ": ") != std::string::npos) probability += belief.probabilities[i];
  }
  return probability;
}

visualization_msgs::MarkerArray bodyMarkers(const RobotDescription& robot,
                                            const hexapod_repertoire::BodyBelief& belief) {
  visualization_msgs::MarkerArray array;
  std::size_t first_body = 1;  // after the base
  for (std::size_t leg = 0; leg < robot.legs.size(); ++leg) {
    Marker line = lineOfLeg(robot, leg, first_body);
    first_body += robot.legs[leg].segments.size();
    const auto share = static_cast<float>(probabilityOutOfOrder(belief, robot.legs[leg].name));
    line.color.r = std::min(1.0f, 2.0f * share);
    line.color.g = std::min(0.8f, 1.6f * (1.0f - share));
    line.color.a = 0.25f + 0.7f * share;
    array.markers.push_back(line);
  }
  Marker text = marker(robot, "believed_body", 0, Marker::TEXT_VIEW_FACING);
  text.pose.position.z = kTextAbove_m;
  text.scale.z = kTextHeight_m;
  text.color.a = 1.0f;
  text.text = belief.sentence;
  array.markers.push_back(text);
  return array;
}

}  // namespace hexapod
