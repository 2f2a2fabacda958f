#pragma once

#include <geometry_msgs/PointStamped.h>
#include <interactive_markers/interactive_marker_server.h>
#include <interactive_markers/menu_handler.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <tf2/buffer_core.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "repertoire/entry.h"

namespace hexapod {

/// The end points of a repertoire as something to click in rviz: one interactive marker whatever
/// the number of entries, which tells where it was clicked.
///
/// While somebody tells on repertoire_pointer where the mouse is - the panel in rviz does -, only
/// the entry below it and the one that was chosen last have a handle, which shows: ten thousand
/// would be slow and hide each other. Otherwise all have one, all but transparent.
///
/// A left click plays the entry, a right click opens a menu: play it, look at it, its gait, its
/// neighbours, do not use it. Callbacks come by the global callback queue.
class ArchiveHandle {
 public:
  enum class Wish { kPlay, kLookAt, kGait, kNeighbours, kExclude };
  using OnClick = std::function<void(Wish wish, const Entry& entry)>;

  /// `frame`: the archive's origin. The buffer must outlive it.
  ArchiveHandle(ros::NodeHandle& node, std::string frame, const tf2::BufferCore& buffer,
                OnClick on_click);

  /// From now on these can be clicked.
  void show(const std::vector<Entry>& entries);

  /// The entry that was chosen.
  void choose(std::int64_t entry_id);

  /// Notices who tells where the mouse is. To be called every now and then.
  void lookForPointer();

 private:
  using Feedback = visualization_msgs::InteractiveMarkerFeedbackConstPtr;

  void receivePointer(const geometry_msgs::PointStamped::ConstPtr& place);
  void receive(Wish wish, const Feedback& feedback);
  /// The entry at a place in any frame; throws tf2::TransformException.
  std::optional<std::size_t> entryAt(const geometry_msgs::PointStamped& place) const;
  std::vector<Entry> handled() const;
  void update();

  const std::string frame_;
  const tf2::BufferCore& buffer_;
  const OnClick on_click_;
  interactive_markers::InteractiveMarkerServer server_;
  interactive_markers::MenuHandler menu_;
  ros::Subscriber pointer_subscriber_;
  std::vector<Entry> entries_;
  bool has_pointer_ = false;
  std::optional<std::int64_t> hovered_;  // ids of entries
  std::optional<std::int64_t> chosen_;
};

}  // namespace hexapod
