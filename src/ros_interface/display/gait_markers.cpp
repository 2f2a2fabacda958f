#include "ros_interface/display/gait_markers.h"

#include <algorithm>

#include "common/text.h"
#include "ros_interface/display/marker_parts.h"
#include "simulation/foot.h"

namespace hexapod {
namespace {

using visualization_msgs::Marker;

constexpr char kName[] = "gait";
constexpr double kDiagramWidth_m = 0.4;
constexpr double kRow_m = 0.035;
constexpr double kLetters_m = 0.024;
constexpr double kLabel_m = 0.09;  // middle of a label left of its row
constexpr double kAboveFloor_m = 0.012;

// A point of the diagram: right of and below its corner.
geometry_msgs::Point place(const Pose2& frame_from_corner, double right_m, double below_m) {
  const Pose2 pose = frame_from_corner * Pose2{-below_m, -right_m, 0.0};
  return point(pose.x_m, pose.y_m, kAboveFloor_m);
}

Marker textAt(const std::string& frame, int id, const std::string& text,
              const geometry_msgs::Point& position) {
  Marker words = textMarker(frame, kName, id, text, kLetters_m);
  words.pose.position = position;
  return words;
}

}  // namespace

GaitPicture gaitOf(const RobotDescription& robot, const Recording& recording, double period_s) {
  const double standing_m = standingFootHeight(robot);
  GaitPicture picture;
  picture.period_s = period_s;
  for (const Leg& leg : robot.legs) picture.legs.push_back(leg.name);
  for (const RecordedPose& pose : recording.poses) {
    std::vector<bool> row;
    for (const Foot& foot : feetOf(robot, pose)) row.push_back(foot.height_m < standing_m);
    picture.stands.push_back(row);
  }
  return picture;
}

visualization_msgs::MarkerArray gaitMarkers(const GaitPicture& picture, const std::string& frame,
                                            const Pose2& frame_from_corner) {
  visualization_msgs::MarkerArray array;
  const std::size_t count = picture.stands.size();
  const double step_m = kDiagramWidth_m / static_cast<double>(std::max<std::size_t>(count, 1));
  Marker bars = marker(frame, kName, 0, Marker::LINE_LIST, 0.7 * kRow_m);
  bars.color = color(0.15, 0.15, 0.15);
  for (std::size_t leg = 0; leg < picture.legs.size(); ++leg) {
    const double below_m = kRow_m * static_cast<double>(leg + 1);
    std::size_t begin = 0;
    for (std::size_t k = 0; k <= count; ++k) {
      const bool stands = k < count && picture.stands[k][leg];
      if (!stands) {
        if (k > begin) {
          bars.points.push_back(
              place(frame_from_corner, step_m * static_cast<double>(begin), below_m));
          bars.points.push_back(place(frame_from_corner, step_m * static_cast<double>(k), below_m));
        }
        begin = k + 1;
      }
    }
    array.markers.push_back(textAt(frame, static_cast<int>(leg) + 1, picture.legs[leg],
                                   place(frame_from_corner, -kLabel_m, below_m)));
  }
  const double duration_s = picture.period_s * static_cast<double>(count);
  array.markers.push_back(
      textAt(frame, static_cast<int>(picture.legs.size()) + 1,
             picture.title + ": dark while a foot stands, " + fixedText(duration_s, 1) + " s",
             place(frame_from_corner, 0.5 * kDiagramWidth_m, 0.0)));
  array.markers.push_back(shown(bars));
  return array;
}

visualization_msgs::MarkerArray noGaitMarkers(std::size_t legs, const std::string& frame) {
  visualization_msgs::MarkerArray array;
  for (std::size_t id = 0; id <= legs + 1; ++id) {
    Marker gone = marker(frame, kName, static_cast<int>(id), Marker::LINE_LIST, kRow_m);
    gone.action = Marker::DELETE;
    array.markers.push_back(gone);
  }
  return array;
}

}  // namespace hexapod
