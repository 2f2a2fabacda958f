#pragma once

#include <interactive_markers/interactive_marker_server.h>
#include <interactive_markers/menu_handler.h>
#include <tf2/buffer_core.h>

#include <functional>
#include <string>

#include "repertoire/repertoire.h"

namespace hexapod {

/// The end points of a repertoire as something to click in rviz: one interactive marker whatever
/// the number of entries, which tells where it was clicked.
///
/// A left click plays the entry, a right click opens a menu: play it, look at it, its gait, its
/// neighbours, do not use it. Callbacks come
/// by the global callback queue.
class ArchiveHandle {
 public:
  enum class Wish { kPlay, kLookAt, kGait, kNeighbours, kExclude };
  /// A place in the frame of the handle [m].
  using OnClick = std::function<void(Wish wish, double x_m, double y_m)>;

  /// `frame`: the archive's origin. The buffer must outlive it.
  ArchiveHandle(const std::string& topic, std::string frame, const tf2::BufferCore& buffer,
                OnClick on_click);

  void show(const Repertoire& repertoire);

 private:
  using Feedback = visualization_msgs::InteractiveMarkerFeedbackConstPtr;

  void receive(Wish wish, const Feedback& feedback);

  const std::string frame_;
  const tf2::BufferCore& buffer_;
  const OnClick on_click_;
  interactive_markers::InteractiveMarkerServer server_;
  interactive_markers::MenuHandler menu_;
};

}  // namespace hexapod
