#include "ros_interface/display/body_markers.h"

#include <algorithm>
#include <cstddef>

#include "ros_interface/display/marker_parts.h"
#include "ros_interface/display/standing_leg.h"

namespace hexapod {
namespace {

using visualization_msgs::Marker;

constexpr double kLegWidth_m = 0.02;
constexpr double kTextAbove_m = 0.2;
constexpr double kBeliefHeight_m = 0.04;

Marker lineOfLeg(const RobotDescription& robot, std::size_t leg) {
  Marker line = marker(robot.base_link, "believed_legs", static_cast<int>(leg), Marker::LINE_STRIP,
                       kLegWidth_m);
  line.frame_locked = true;
  const Eigen::AngleAxisd link_from_base(robot.link_from_base_yaw_rad, Eigen::Vector3d::UnitZ());
  for (const Eigen::Vector3d& joint : standingLeg(robot, leg)) {
    line.points.push_back(point(link_from_base * joint));
  }
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
  for (std::size_t leg = 0; leg < robot.legs.size(); ++leg) {
    Marker line = lineOfLeg(robot, leg);
    const auto share = static_cast<float>(probabilityOutOfOrder(belief, robot.legs[leg].name));
    line.color.r = std::min(1.0f, 2.0f * share);
    line.color.g = std::min(0.8f, 1.6f * (1.0f - share));
    line.color.a = 0.25f + 0.7f * share;
    array.markers.push_back(line);
  }
  Marker text = textMarker(robot.base_link, "believed_body", 0, belief.sentence, kBeliefHeight_m);
  text.frame_locked = true;
  text.pose.position.z = kTextAbove_m;
  array.markers.push_back(text);
  return array;
}

}  // namespace hexapod
