#include "ros_interface/browser/archive_handle.h"

#include <ros/console.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "repertoire/entry_choice.h"
#include "ros_interface/common/names.h"
#include "ros_interface/display/marker_parts.h"

namespace hexapod {
namespace {

using visualization_msgs::InteractiveMarker;
using visualization_msgs::InteractiveMarkerControl;
using visualization_msgs::InteractiveMarkerFeedback;
using visualization_msgs::Marker;

constexpr char kHandleTopic[] = "repertoire_handles";
constexpr char kName[] = "repertoire";
// Larger than what is drawn of an entry and above it: easy to hit.
constexpr double kWidth_m = 0.03;
// Of a single one: all from where the mouse means it.
constexpr double kWidthOfOne_m = 0.06;
constexpr double kHeight_m = 0.015;
constexpr double kOpacityOfAll = 0.05;
constexpr double kOpacityOfOne = 0.3;
// A click so far from every end means none of them.
constexpr double kReach_m = 0.05;

/// Hexagons: rviz does not find the mouse over spheres of a list.
Marker hexagonsAt(const std::vector<Entry>& entries, const std::string& frame, double width_m) {
  constexpr int kCorners = 6;
  Marker hexagons = marker(frame, kName, 0, Marker::TRIANGLE_LIST, 1.0);
  hexagons.scale.z = 1.0;
  for (const Entry& entry : entries) {
    const auto corner = [&, &end = entry.expectedPose()](int i) {
      const double angle = 2.0 * M_PI * i / kCorners;
      return point(end.x_m + 0.5 * width_m * std::cos(angle),
                   end.y_m + 0.5 * width_m * std::sin(angle), kHeight_m);
    };
    for (int i = 1; i < kCorners - 1; ++i) {
      for (const int k : {0, i, i + 1}) hexagons.points.push_back(corner(k));
    }
  }
  return hexagons;
}

}  // namespace

ArchiveHandle::ArchiveHandle(ros::NodeHandle& node, std::string frame,
                             const tf2::BufferCore& buffer, OnClick on_click)
    : frame_(std::move(frame)),
      buffer_(buffer),
      on_click_(std::move(on_click)),
      server_(kHandleTopic, "", false),
      pointer_subscriber_(
          node.subscribe(names::kRepertoirePointer, 1, &ArchiveHandle::receivePointer, this)) {
  const std::pair<const char*, Wish> entries[] = {{"Play it", Wish::kPlay},
                                                  {"Look at it", Wish::kLookAt},
                                                  {"Show its gait", Wish::kGait},
                                                  {"Show its neighbours", Wish::kNeighbours},
                                                  {"Do not use it", Wish::kExclude}};
  for (const auto& [title, wish] : entries) {
    menu_.insert(title, [this, wish = wish](const Feedback& feedback) { receive(wish, feedback); });
  }
}

void ArchiveHandle::show(const std::vector<Entry>& entries) {
  entries_ = entries;
  update();
}

void ArchiveHandle::choose(std::int64_t entry_id) {
  chosen_ = entry_id;
  if (has_pointer_) update();
}

void ArchiveHandle::lookForPointer() {
  const bool has_pointer = pointer_subscriber_.getNumPublishers() > 0;
  if (has_pointer == has_pointer_) return;
  has_pointer_ = has_pointer;
  update();
}

void ArchiveHandle::receivePointer(const geometry_msgs::PointStamped::ConstPtr& place) {
  try {
    const auto found = entryAt(*place);
    if (!found || entries_[*found].id == hovered_) return;  // the last one stays
    hovered_ = entries_[*found].id;
    if (has_pointer_) update();
  } catch (const tf2::TransformException& error) {
    ROS_WARN_STREAM_THROTTLE(10.0, "Where the mouse points cannot be brought into the frame "
                                       << frame_ << ": " << error.what());
  }
}

std::vector<Entry> ArchiveHandle::handled() const {
  if (!has_pointer_) return entries_;
  std::vector<Entry> few;
  std::copy_if(entries_.begin(), entries_.end(), std::back_inserter(few),
               [this](const Entry& e) { return e.id == hovered_ || e.id == chosen_; });
  return few;
}

void ArchiveHandle::update() {
  server_.clear();
  const std::vector<Entry> entries = handled();
  if (!entries.empty()) {
    InteractiveMarkerControl control;
    control.name = kName;
    control.interaction_mode = InteractiveMarkerControl::BUTTON;
    control.always_visible = true;
    control.markers.push_back(hexagonsAt(entries, frame_, has_pointer_ ? kWidthOfOne_m : kWidth_m));
    control.markers.back().color =
        has_pointer_ ? color(0.85, 0.33, 0.1, kOpacityOfOne) : color(0.5, 0.5, 0.5, kOpacityOfAll);
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

std::optional<std::size_t> ArchiveHandle::entryAt(const geometry_msgs::PointStamped& place) const {
  const auto transform = buffer_.lookupTransform(frame_, place.header.frame_id, ros::Time(0));
  geometry_msgs::Point here;
  tf2::doTransform(place.point, here, transform);
  return entryNear(entries_, here.x, here.y, kReach_m);
}

void ArchiveHandle::receive(Wish wish, const Feedback& feedback) {
  if (!feedback->mouse_point_valid) {
    ROS_WARN("rviz did not say where it was clicked; click again.");
    return;
  }
  try {
    geometry_msgs::PointStamped place;
    place.header.frame_id = feedback->header.frame_id;
    place.point = feedback->mouse_point;
    const auto found = entryAt(place);
    if (!found) return;
    const Entry entry = entries_[*found];  // entries_ may change
    on_click_(wish, entry);
  } catch (const tf2::TransformException& error) {
    ROS_WARN_STREAM("The click cannot be brought into the frame " << frame_ << ": "
                                                                  << error.what());
  }
}

}  // namespace hexapod
