#include "ros_interface/display/scene_markers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "common/text.h"
#include "geometry/arc.h"
#include "geometry/pose2.h"
#include "repertoire/metrics.h"
#include "robot/dimensions.h"
#include "ros_interface/display/marker_parts.h"
#include "ros_interface/display/repertoire_markers.h"
#include "ros_interface/display/standing_leg.h"

namespace hexapod {
namespace {

using visualization_msgs::Marker;

constexpr double kLineHeight_m = 0.003;
constexpr double kTextHeight_m = 0.035;
// Figures stand to the left of the region of interest, the legend to its right.
constexpr double kMargin_m = 0.1;

geometry_msgs::Point onFloor(double x_m, double y_m) { return point(x_m, y_m, kLineHeight_m); }

Marker outline(const RobotDescription& robot, const std::string& frame) {
  Marker lines = marker(frame, "robot_outline", 0, Marker::LINE_LIST, 0.006);
  lines.color = color(0.35, 0.35, 0.35);
  std::vector<Eigen::Vector3d> hips;
  for (std::size_t leg = 0; leg < robot.legs.size(); ++leg) {
    const std::vector<Eigen::Vector3d> joints = standingLeg(robot, leg);
    hips.push_back(joints.front());
    for (std::size_t k = 0; k + 1 < joints.size(); ++k) {
      lines.points.push_back(onFloor(joints[k].x(), joints[k].y()));
      lines.points.push_back(onFloor(joints[k + 1].x(), joints[k + 1].y()));
    }
  }
  // The trunk, from hip to hip in the order of their directions.
  std::sort(hips.begin(), hips.end(), [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::atan2(a.y(), a.x()) < std::atan2(b.y(), b.x());
  });
  for (std::size_t i = 0; i < hips.size(); ++i) {
    const Eigen::Vector3d& next = hips[(i + 1) % hips.size()];
    lines.points.push_back(onFloor(hips[i].x(), hips[i].y()));
    lines.points.push_back(onFloor(next.x(), next.y()));
  }
  return shown(lines);
}

Marker forwardArrow(const RobotDescription& robot, const std::string& frame) {
  Marker arrow = marker(frame, "robot_outline", 1, Marker::ARROW, legReach_m(robot));
  arrow.scale.y = 0.06 * arrow.scale.x;
  arrow.scale.z = 0.06 * arrow.scale.x;
  arrow.pose.position.z = kLineHeight_m;
  arrow.color = color(0.85, 0.33, 0.1);
  return arrow;
}

// In front and in the rear: the sides, and the ends of the arcs in between.
Marker regionOfInterest(const RegionOfInterest& region, const std::string& frame) {
  constexpr int kCorners = 48;
  Marker line = marker(frame, "region_of_interest", 0, Marker::LINE_STRIP, 0.003);
  line.color = color(0.5, 0.5, 0.5);
  for (const double direction : {1.0, -1.0}) {
    line.points.push_back(onFloor(0.0, 0.0));
    for (int i = 0; i <= kCorners; ++i) {
      // An arc that ends at the polar angle a has turned by 2 a and is as long as its chord a / sin
      // a.
      const double angle = region.half_angle_rad * (2.0 * i / kCorners - 1.0);
      const double chord_m =
          region.arc_length_m * (std::abs(angle) < 1e-9 ? 1.0 : std::sin(angle) / angle);
      line.points.push_back(
          onFloor(direction * chord_m * std::cos(angle), direction * chord_m * std::sin(angle)));
    }
    line.points.push_back(onFloor(0.0, 0.0));
  }
  return line;
}

void addLegend(double x_m, double y_m, const std::string& frame,
               visualization_msgs::MarkerArray& array) {
  constexpr double kStep_m = 0.05;
  Marker scale = marker(frame, "legend", 0, Marker::SPHERE_LIST, 0.04);
  scale.scale.z = 0.002;
  for (int i = 0; i <= 4; ++i) {
    scale.points.push_back(onFloor(x_m - i * kStep_m, y_m));
    scale.colors.push_back(errorColor(2.5 * i * kDegree));
  }
  array.markers.push_back(scale);
  for (int i = 0; i <= 4; i += 2) {
    const std::string text = (i == 4 ? ">= " : "") + fixedText(2.5 * i, 0) + " deg";
    Marker label = textMarker(frame, "legend", 1 + i, text, 0.9 * kTextHeight_m);
    label.pose.position = point(x_m - i * kStep_m, y_m - 0.14, 0.0);
    label.color = color(0.1, 0.1, 0.1);
    array.markers.push_back(label);
  }
  Marker title = textMarker(frame, "legend", 9, "orientation error", 0.9 * kTextHeight_m);
  title.pose.position = point(x_m + 1.5 * kStep_m, y_m - 0.1, 0.0);
  array.markers.push_back(title);
}

}  // namespace

double roomBeside_m(const RobotDescription& robot) {
  return RegionOfInterest().scaledBy(lengthScale(robot)).arc_length_m + kMargin_m;
}

std::string figuresOf(const Repertoire& repertoire, const RobotDescription& robot) {
  const RepertoireMetrics metrics =
      measure(expectedEndings(repertoire.entries), RegionOfInterest().scaledBy(lengthScale(robot)));
  std::string text = std::to_string(repertoire.entries.size()) + " behaviours of " +
                     std::to_string(repertoire.evaluations) + " tried";
  if (metrics.endings == 0) return text;
  return text + "\nsparseness " + fixedText(100.0 * metrics.sparseness_m, 2) +
         " cm\norientation error " + fixedText(metrics.median_error_in_region_rad / kDegree, 2) +
         " deg";
}

visualization_msgs::MarkerArray sceneMarkers(const RobotDescription& robot,
                                             const Repertoire& repertoire,
                                             const std::string& frame) {
  const RegionOfInterest region = RegionOfInterest().scaledBy(lengthScale(robot));
  visualization_msgs::MarkerArray array;
  array.markers = {outline(robot, frame), forwardArrow(robot, frame),
                   regionOfInterest(region, frame)};
  const double beside_m = roomBeside_m(robot);
  Marker figures = textMarker(frame, "figures", 0, figuresOf(repertoire, robot), kTextHeight_m);
  figures.pose.position = point(0.4 * region.arc_length_m, beside_m, 0.0);
  array.markers.push_back(figures);
  addLegend(0.4 * region.arc_length_m, -beside_m, frame, array);
  for (Marker& marker : array.markers) marker.frame_locked = true;
  return array;
}

}  // namespace hexapod
