#include "ros_interface/display/markers.h"

#include <algorithm>
#include <cmath>

#include "geometry/arc.h"
#include "ros_interface/common/conversions.h"
#include "ros_interface/display/marker_parts.h"

namespace hexapod {
namespace {

constexpr double kWorstShown_rad = 10.0 * M_PI / 180.0;
constexpr double kTickLength = 0.025;
constexpr double kHeightAboveFloor = 0.005;
constexpr double kHeightOfTangents = 0.008;
// An end point is a sphere as flat as a disc.
constexpr double kDisc_m = 0.014;
constexpr double kDiscHeight_m = 0.002;

geometry_msgs::Point onFloor(const Pose2& pose, double height_m = kHeightAboveFloor) {
  return point(pose.x_m, pose.y_m, height_m);
}

// A part of the line from a pose along a heading: from and to as shares of kTickLength.
void addTick(visualization_msgs::Marker& lines, const Pose2& pose, double heading_rad,
             double height_m = kHeightAboveFloor, double from = 0.0, double to = 1.0) {
  for (const double share : {from, to}) {
    const double way_m = share * kTickLength;
    lines.points.push_back(onFloor(
        {pose.x_m + way_m * std::cos(heading_rad), pose.y_m + way_m * std::sin(heading_rad), 0.0},
        height_m));
  }
}

// Dashed, and above the solid line of the heading: where both agree, both are seen.
void addDashedTick(visualization_msgs::Marker& lines, const Pose2& pose, double heading_rad) {
  constexpr int kDashes = 3;
  constexpr double kPitch = 1.0 / kDashes;
  for (int i = 0; i < kDashes; ++i) {
    addTick(lines, pose, heading_rad, kHeightOfTangents, (i + 0.4) * kPitch, (i + 1.0) * kPitch);
  }
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

std_msgs::ColorRGBA errorColor(double orientation_error_rad) {
  // SHADES of pictures.py.
  constexpr double kScale[][3] = {{0.361, 0.786, 0.388},
                                  {0.120, 0.622, 0.535},
                                  {0.174, 0.445, 0.558},
                                  {0.261, 0.247, 0.523},
                                  {0.267, 0.005, 0.329}};
  constexpr int kSpans = 4;
  const double place = kSpans * std::min(1.0, std::abs(orientation_error_rad) / kWorstShown_rad);
  const int span = std::min(kSpans - 1, static_cast<int>(place));
  const auto mixed = [&](int channel) {
    const double light = kScale[span][channel];
    return light + (place - span) * (kScale[span + 1][channel] - light);
  };
  return color(mixed(0), mixed(1), mixed(2));
}

visualization_msgs::MarkerArray repertoireMarkers(const Repertoire& repertoire,
                                                  const std::string& frame) {
  auto discs = marker(frame, "end_points", 0, visualization_msgs::Marker::SPHERE_LIST, kDisc_m);
  auto headings = marker(frame, "headings", 1, visualization_msgs::Marker::LINE_LIST, 0.003);
  auto tangents = marker(frame, "tangents", 2, visualization_msgs::Marker::LINE_LIST, 0.0015);
  discs.scale.z = kDiscHeight_m;
  headings.color = color(0.1, 0.35, 0.9);
  tangents.color = color(0.1, 0.1, 0.1);
  for (const Entry& entry : repertoire.entries) {
    const Pose2& pose = entry.expectedPose();
    discs.points.push_back(onFloor(pose));
    discs.colors.push_back(entry.usable() ? errorColor(orientationError(pose))
                                          : color(0.5, 0.5, 0.5));
    addTick(headings, pose, pose.yaw_rad);
    addDashedTick(tangents, pose, arcThrough(pose.x_m, pose.y_m).heading_rad);
  }
  visualization_msgs::MarkerArray array;
  for (auto* list : {&discs, &headings, &tangents}) {
    list->frame_locked = true;
    array.markers.push_back(shown(*list));
  }
  return array;
}

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
    addTick(headings, pose, pose.yaw_rad);
  }
  visualization_msgs::MarkerArray array;
  array.markers = {shown(path),   shown(stops),      shown(headings),
                   shown(walked), goalRing(picture), goalArrow(picture)};
  return array;
}

}  // namespace hexapod
