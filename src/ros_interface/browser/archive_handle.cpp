#include "ros_interface/browser/archive_handle.h"

#include <ros/console.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include <utility>

#include "ros_interface/display/marker_parts.h"

namespace hexapod {
namespace {

using visualization_msgs::InteractiveMarker;
using visualization_msgs::InteractiveMarkerControl;
using visualization_msgs::InteractiveMarkerFeedback;
using visualization_msgs::Marker;

constexpr char kName[] = "repertoire";
// Larger than what is drawn of an entry and above it: easy to hit, and all but transparent.
constexpr double kWidth_m = 0.03;
constexpr double kHeight_m = 0.015;
constexpr double kOpacity = 0.05;

}  // namespace

ArchiveHandle::ArchiveHandle(const std::string& topic, std::string frame,
                             const tf2::BufferCore& buffer, OnClick on_click)
    : frame_(std::move(frame)),
      buffer_(buffer),
      on_click_(std::move(on_click)),
      server_(topic, "", false) {
  const std::pair<const char*, Wish> entries[] = {{"Play it", Wish::kPlay},
                                                  {"Look at it", Wish::kLookAt},
                                                  {"Show its gait", Wish::kGait},
                                                  {"Show its neighbours", Wish::kNeighbours},
                                                  {"Do not use it", Wish::kExclude}};
  for (const auto& [title, wish] : entries) {
    menu_.insert(title, [this, wish = wish](const Feedback& feedback) { receive(wish, feedback); });
  }
}

void ArchiveHandle::show(const Repertoire& repertoire) {
  server_.clear();
  if (!repertoire.entries.empty()) {
    Marker points = marker(frame_, kName, 0, Marker::SPHERE_LIST, kWidth_m);
    points.scale.z = 0.1 * kWidth_m;
    points.color = color(0.5, 0.5, 0.5, kOpacity);
    for (const Entry& entry : repertoire.entries) {
      points.points.push_back(point(entry.expectedPose().x_m, entry.expectedPose().y_m, kHeight_m));
    }
    InteractiveMarkerControl control;
    control.name = kName;
    control.interaction_mode = InteractiveMarkerControl::BUTTON;
    control.always_visible = true;
    control.markers.push_back(points);
    InteractiveMarker handle;
    handle.header.frame_id = frame_;
    handle.name = kName;
    handle.scale = 1.0;
    handle.controls.push_back(control);
    server_.insert(handle, [this](const Feedback& feedback) {
      if (feedback->event_type == InteractiveMarkerFeedback::BUTTON_CLICK) {
        receive(Wish::kPlay, feedback);
      }
    });
    menu_.apply(server_, kName);
  }
  server_.applyChanges();
}

void ArchiveHandle::receive(Wish wish, const Feedback& feedback) {
  if (!feedback->mouse_point_valid) {
    ROS_WARN("rviz did not say where it was clicked; click again.");
    return;
  }
  try {
    const auto transform = buffer_.lookupTransform(frame_, feedback->header.frame_id, ros::Time(0));
    geometry_msgs::Point place;
    tf2::doTransform(feedback->mouse_point, place, transform);
    on_click_(wish, place.x, place.y);
  } catch (const tf2::TransformException& error) {
    ROS_WARN_STREAM("The click cannot be brought into the frame " << frame_ << ": "
                                                                  << error.what());
  }
}

}  // namespace hexapod
