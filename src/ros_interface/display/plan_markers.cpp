#include "ros_interface/display/plan_markers.h"

#include <algorithm>
#include <cmath>

#include "common/text.h"
#include "planning/path.h"
#include "ros_interface/common/conversions.h"
#include "ros_interface/display/marker_parts.h"

namespace hexapod {
namespace {

constexpr double kTickLength = 0.025;
constexpr double kHeightAboveFloor = 0.005;
constexpr double kPlanTextHeight_m = 0.04;
constexpr double kTextAt_m = 0.06;
constexpr double kTrailSpacing_m = 0.02;
constexpr std::size_t kTextColumns = 44;

geometry_msgs::Point onFloor(const Pose2& pose) {
  return point(pose.x_m, pose.y_m, kHeightAboveFloor);
}

// A line from a pose along its heading.
void addTick(visualization_msgs::Marker& lines, const Pose2& pose) {
  lines.points.push_back(onFloor(pose));
  lines.points.push_back(onFloor(pose * Pose2{kTickLength, 0.0, 0.0}));
}

// A ring and an arrow.
void addGoal(const std::string& frame, const std::string& name, const Pose2& goal,
             double xy_tolerance_m, const std_msgs::ColorRGBA& tint,
             visualization_msgs::MarkerArray& array) {
  auto ring = marker(frame, name, 0, visualization_msgs::Marker::LINE_STRIP, 0.008);
  const double radius_m = std::max(xy_tolerance_m, 0.01);
  constexpr int kCorners = 36;
  for (int i = 0; i <= kCorners; ++i) {
    const double angle = 2.0 * M_PI * i / kCorners;
    ring.points.push_back(onFloor(
        {goal.x_m + radius_m * std::cos(angle), goal.y_m + radius_m * std::sin(angle), 0.0}));
  }
  auto arrow = marker(frame, name, 1, visualization_msgs::Marker::ARROW, 0.15);
  arrow.pose = toPoseMsg(goal);
  arrow.scale.y = 0.02;
  arrow.scale.z = 0.02;
  ring.color = arrow.color = tint;
  array.markers.push_back(ring);
  array.markers.push_back(arrow);
}

std::string inShortLines(const std::string& sentence) {
  std::string text;
  for (const std::string& line : inLines(sentence, kTextColumns)) {
    text += (text.empty() ? "" : "\n") + line;
  }
  return text;
}

double linesOf(const std::string& text) {
  return 1.0 + static_cast<double>(std::count(text.begin(), text.end(), '\n'));
}

visualization_msgs::Marker textAt(const std::string& frame, const std::string& name, int id,
                                  const std::string& text, const Pose2& pose) {
  auto label = textMarker(frame, name, id, text, kPlanTextHeight_m);
  label.pose.position = point(pose.x_m, pose.y_m, kTextAt_m);
  return label;
}

void addPlan(const PlanPicture& picture, visualization_msgs::MarkerArray& array) {
  auto path = marker(picture.frame, "path", 0, visualization_msgs::Marker::LINE_STRIP, 0.008);
  auto stops = marker(picture.frame, "stops", 0, visualization_msgs::Marker::POINTS, 0.025);
  auto headings = marker(picture.frame, "stops", 1, visualization_msgs::Marker::LINE_LIST, 0.006);
  path.color = stops.color = color(0.1, 0.7, 0.2);
  headings.color = color(0.05, 0.4, 0.1);
  for (const Pose2& pose : picture.path) path.points.push_back(onFloor(pose));
  std::size_t number = std::max<std::size_t>(picture.walked.size(), 1);
  for (const Pose2& pose : picture.stops) {
    stops.points.push_back(onFloor(pose));
    addTick(headings, pose);
    array.markers.push_back(
        textAt(picture.frame, "numbers", static_cast<int>(number), std::to_string(number), pose));
    ++number;
  }
  for (const auto& list : {path, stops, headings}) array.markers.push_back(shown(list));
}

void addTrail(const PlanPicture& picture, visualization_msgs::MarkerArray& array) {
  auto trail = marker(picture.frame, "walked", 0, visualization_msgs::Marker::LINE_STRIP, 0.008);
  auto reached = marker(picture.frame, "walked", 1, visualization_msgs::Marker::POINTS, 0.02);
  auto predicted = marker(picture.frame, "misses", 0, visualization_msgs::Marker::POINTS, 0.012);
  auto misses = marker(picture.frame, "misses", 1, visualization_msgs::Marker::LINE_LIST, 0.006);
  trail.color = reached.color = color(0.95, 0.6, 0.1);
  predicted.color = misses.color = color(0.05, 0.4, 0.1);
  if (!picture.walked.empty()) {
    const std::vector<Pose2> later(picture.walked.begin() + 1, picture.walked.end());
    for (const Pose2& pose : samplePath(picture.walked.front(), later, kTrailSpacing_m)) {
      trail.points.push_back(onFloor(pose));
    }
  }
  for (const Pose2& pose : picture.walked) reached.points.push_back(onFloor(pose));
  for (const Miss& miss : picture.misses) {
    predicted.points.push_back(onFloor(miss.predicted));
    misses.points.push_back(onFloor(miss.predicted));
    misses.points.push_back(onFloor(miss.reached));
  }
  for (const auto& list : {trail, reached, predicted, misses}) array.markers.push_back(shown(list));
}

}  // namespace

visualization_msgs::MarkerArray planMarkers(const PlanPicture& picture) {
  visualization_msgs::MarkerArray array;
  array.markers.push_back(
      marker(picture.frame, "", 0, visualization_msgs::Marker::SPHERE_LIST, 1.0));
  array.markers.back().action = visualization_msgs::Marker::DELETEALL;
  addPlan(picture, array);
  addTrail(picture, array);
  addGoal(picture.frame, "goal", picture.goal, picture.xy_tolerance_m, color(0.9, 0.2, 0.6), array);
  return array;
}

visualization_msgs::Marker footprintMarker(const Footprint& footprint, const std::string& frame) {
  constexpr int kCorners = 72;
  auto rim = marker(frame, "footprint", 0, visualization_msgs::Marker::LINE_LIST, 0.004);
  rim.color = color(0.3, 0.5, 0.7);
  rim.frame_locked = true;
  const std::vector<Disc>& discs = footprint.discs;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const auto corner = [&](int k) {
      const double angle = 2.0 * M_PI * k / kCorners;
      return Pose2{discs[i].x_m + discs[i].radius_m * std::cos(angle),
                   discs[i].y_m + discs[i].radius_m * std::sin(angle), 0.0};
    };
    const auto isInAnother = [&](const Pose2& at) {
      for (std::size_t j = 0; j < discs.size(); ++j) {
        if (j == i) continue;
        if (std::hypot(at.x_m - discs[j].x_m, at.y_m - discs[j].y_m) < discs[j].radius_m)
          return true;
      }
      return false;
    };
    for (int k = 0; k < kCorners; ++k) {
      if (isInAnother(corner(k)) || isInAnother(corner(k + 1))) continue;
      rim.points.push_back(onFloor(corner(k)));
      rim.points.push_back(onFloor(corner(k + 1)));
    }
  }
  return shown(rim);
}

visualization_msgs::MarkerArray refusedMarkers(const RefusedGoal& refused) {
  visualization_msgs::MarkerArray array;
  addGoal(refused.frame, "refused", refused.goal, refused.xy_tolerance_m, color(0.8, 0.0, 0.0),
          array);
  auto reason = textAt(refused.frame, "refused", 2, inShortLines(refused.reason), refused.goal);
  reason.pose.position.z = 0.1 + 0.7 * kPlanTextHeight_m * linesOf(reason.text);  // it is centred
  reason.color = color(0.8, 0.0, 0.0);
  array.markers.push_back(reason);
  visualization_msgs::MarkerArray nearest;
  const Pose2 pose = refused.nearest.value_or(Pose2());
  addGoal(refused.frame, "nearest", pose, refused.xy_tolerance_m, color(0.1, 0.35, 0.9), nearest);
  nearest.markers.push_back(
      textAt(refused.frame, "nearest", 2, "nearest that can be reached", pose));
  for (visualization_msgs::Marker& part : nearest.markers) {
    if (!refused.nearest) part.action = visualization_msgs::Marker::DELETE;  // of an earlier one
    array.markers.push_back(part);
  }
  return array;
}

}  // namespace hexapod
