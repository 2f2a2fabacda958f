#include "ros_interface/display/entry_markers.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "common/text.h"
#include "geometry/arc.h"
#include "geometry/pose2.h"
#include "repertoire/describe_entry.h"
#include "ros_interface/common/conversions.h"
#include "ros_interface/display/marker_parts.h"

namespace hexapod {
namespace {

using visualization_msgs::Marker;

constexpr double kEntryAbove_m = 0.012;
constexpr double kEntryLetters_m = 0.03;
constexpr double kRing_m = 0.025;
constexpr double kHeading_m = 0.08;

std::string inDegrees(double angle_rad, int decimals) {
  return fixedText(angle_rad / kDegree, decimals) + " deg";
}

Marker arcOf(const EntryPicture& picture) {
  constexpr int kParts = 40;
  Marker line = marker(picture.frame, "entry", 0, Marker::LINE_STRIP, 0.006);
  line.color = color(0.85, 0.33, 0.1);
  const Pose2& end = picture.entry.expectedPose();
  const Arc arc = arcThrough(end.x_m, end.y_m);
  for (int i = 0; i <= kParts; ++i) {
    const Pose2 pose = picture.start * arc.at(static_cast<double>(i) / kParts);
    line.points.push_back(point(pose.x_m, pose.y_m, kEntryAbove_m));
  }
  return line;
}

Marker ringAround(const Pose2& pose, const std::string& frame) {
  constexpr int kCorners = 24;
  Marker ring = marker(frame, "entry", 1, Marker::LINE_STRIP, 0.006);
  ring.color = color(0.85, 0.33, 0.1);
  for (int i = 0; i <= kCorners; ++i) {
    const double angle = 2.0 * M_PI * i / kCorners;
    ring.points.push_back(point(pose.x_m + kRing_m * std::cos(angle),
                                pose.y_m + kRing_m * std::sin(angle), kEntryAbove_m));
  }
  return ring;
}

Marker headingOf(const Pose2& pose, const std::string& frame, int id,
                 const std_msgs::ColorRGBA& tint) {
  Marker arrow = marker(frame, "entry", id, Marker::ARROW, kHeading_m);
  arrow.scale.y = arrow.scale.z = 0.01;
  arrow.pose = toPoseMsg(pose);
  arrow.pose.position.z = kEntryAbove_m;
  arrow.color = tint;
  return arrow;
}

/// Thin rings in one marker.
Marker ringsAround(const EntryPicture& picture) {
  Marker rings = marker(picture.frame, "entry", 5, Marker::LINE_LIST, 0.004);
  rings.color = color(0.2, 0.2, 0.2);
  for (const Entry& neighbour : picture.neighbours) {
    const Marker ring = ringAround(picture.start * neighbour.expectedPose(), picture.frame);
    for (std::size_t i = 1; i < ring.points.size(); ++i) {
      rings.points.push_back(ring.points[i - 1]);
      rings.points.push_back(ring.points[i]);
    }
  }
  return shown(rings);
}

/// A line each: how far it ends, and its orientation error.
std::string neighboursInWords(const EntryPicture& picture) {
  std::string text = "neighbours, how far, their errors:";
  for (const Entry& neighbour : picture.neighbours) {
    const Pose2& end = neighbour.expectedPose();
    text += "\n" + std::to_string(neighbour.id) + ": " +
            fixedText(100.0 * distance(picture.entry.expectedPose(), end), 1) + " cm, " +
            inDegrees(orientationError(end), 1);
  }
  return text;
}

std::string difference(const Pose2& expected, const Pose2& reached) {
  return "reached: " + fixedText(100.0 * distance(expected, reached), 1) + " cm and " +
         inDegrees(headingDistance(expected, reached), 1) + " from there";
}

}  // namespace

visualization_msgs::MarkerArray entryMarkers(const EntryPicture& picture) {
  const Pose2 expected = picture.start * picture.entry.expectedPose();
  visualization_msgs::MarkerArray array;
  array.markers = {arcOf(picture), ringAround(expected, picture.frame),
                   headingOf(expected, picture.frame, 2, color(0.85, 0.33, 0.1))};
  std::string text = describe(picture.entry);
  Marker reached = marker(picture.frame, "entry", 3, Marker::ARROW, kHeading_m);
  if (picture.reached) {
    reached = headingOf(*picture.reached, picture.frame, 3, color(0.1, 0.1, 0.1));
    text += "\n" + difference(expected, *picture.reached);
  } else {
    reached.action = Marker::DELETE;
  }
  if (!picture.neighbours.empty()) text += "\n" + neighboursInWords(picture);
  if (!picture.remark.empty()) text += "\n" + picture.remark;
  Marker words = textMarker(picture.frame, "entry", 4, text, kEntryLetters_m);
  // Beside the robot and its repertoire, where nothing else is.
  const Pose2 place = picture.start * Pose2{0.0, picture.beside_m, 0.0};
  words.pose.position = point(place.x_m, place.y_m, 0.1);
  array.markers.push_back(reached);
  array.markers.push_back(ringsAround(picture));
  array.markers.push_back(words);
  return array;
}

}  // namespace hexapod
