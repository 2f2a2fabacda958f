#include "ros_interface/display/plan_markers.h"

#include <algorithm>
#include <cmath>

#include "ros_interface/common/conversions.h"
#include "ros_interface/display/marker_parts.h"

namespace hexapod {
namespace {

constexpr double kTickLength = 0.025;
constexpr double kHeightAboveFloor = 0.005;

geometry_msgs::Point onFloor(const Pose2& pose) {
  return point(pose.x_m, pose.y_m, kHeightAboveFloor);
}

// A line from a pose along its heading.
void addTick(visualization_msgs::Marker& lines, const Pose2& pose) {
  lines.points.push_back(onFloor(pose));
  lines.points.push_back(onFloor(pose * Pose2{kTickLength, 0.0, 0.0}));
}

visualization_msgs::Marker goalRing(const PlanPicture& picture) {
  auto ring = marker(picture.frame, "goal", 0, visualization_msgs::Marker::LINE_STRIP, 0.008);
  ring.color = color(0.9, 0.2, 0.6);
  const double radius = std::max(picture.xy_tolerance_m, 0.01);
  constexpr int kCorners = 36;
  for (int i = 0; i <= kCorners; ++i) {
    const double angle = 2.0 * M_PI * i / kCorners;
    ring.points.push_back(onFloor({picture.goal.x_m + radius * std::cos(angle),
                                   picture.goal.y_m + radius * std::sin(angle), 0.0}));
  }
  return ring;
}

visualization_msgs::Marker goalArrow(const PlanPicture& picture) {
  auto arrow = marker(picture.frame, "goal", 1, visualization_msgs::Marker::ARROW, 0.15);
  arrow.pose = toPoseMsg(picture.goal);
  arrow.scale.y = 0.02;
  arrow.scale.z = 0.02;
  arrow.color = color(0.9, 0.2, 0.6);
  return arrow;
}

}  // namespace

visualization_msgs::MarkerArray planMarkers(const PlanPicture& picture) {
  auto path = marker(picture.frame, "path", 0, visualization_msgs::Marker::LINE_STRIP, 0.008);
  auto stops = marker(picture.frame, "stops", 0, visualization_msgs::Marker::POINTS, 0.025);
  auto headings = marker(picture.frame, "stops", 1, visualization_msgs::Marker::LINE_LIST, 0.006);
  auto walked = marker(picture.frame, "walked", 0, visualization_msgs::Marker::POINTS, 0.02);
  path.color = color(0.1, 0.7, 0.2);
  stops.color = color(0.1, 0.7, 0.2);
  headings.color = color(0.05, 0.4, 0.1);
  walked.color = color(0.95, 0.6, 0.1);
  for (const Pose2& pose : picture.path) path.points.push_back(onFloor(pose));
  for (const Pose2& pose : picture.walked) walked.points.push_back(onFloor(pose));
  for (const Pose2& pose : picture.stops) {
    stops.points.push_back(onFloor(pose));
    addTick(headings, pose);
  }
  visualization_msgs::MarkerArray array;
  array.markers = {shown(path),   shown(stops),      shown(headings),
                   shown(walked), goalRing(picture), goalArrow(picture)};
  return array;
}

}  // namespace hexapod
