#pragma once

#include <tf2/buffer_core.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "planning/obstacles.h"
#include "ros_interface/planner/map_messages.h"
#include "ros_interface/planner/planner_node_options.h"

namespace hexapod {

/// The newest map and what it means for the robot, brought into the global frame as tf says at the
/// time of asking. One whose frame tf has never told of waits, and the one before stays in use.
///
/// Maps and updates are taken at once; what they mean is worked out by a thread of its own, of the
/// newest state whenever the last one is done: however fast they come, nothing piles up. From any
/// thread.
class MapInUse {
 public:
  /// `footprint` without margin, nothing when the robot is not known. Both references must outlive
  /// it.
  MapInUse(const PlannerNodeOptions& options, const tf2::BufferCore& buffer,
           const std::optional<Footprint>& footprint);
  ~MapInUse();
  MapInUse(const MapInUse&) = delete;
  MapInUse& operator=(const MapInUse&) = delete;

  /// That obstacles are kept from, without margin; nothing when it is not known.
  const std::optional<Footprint>& footprint() const { return footprint_; }

  /// Takes a map, or an update of the one there is. Empty, or a sentence that says why not.
  /// @{
  std::string take(const nav_msgs::OccupancyGrid& message);
  std::string take(const map_msgs::OccupancyGridUpdate& message);
  /// @}

  /// Waits until what was taken is in use.
  void settle() const;

  /// Null as long as there is no map. The same object as long as nothing has changed.
  std::shared_ptr<const Obstacles> obstacles() const;

  /// Why a map waits, as a sentence; empty when none does.
  std::string problem() const;

 private:
  struct Located {
    std::string frame;
    Pose2 frame_from_map;
    std::shared_ptr<const Obstacles> obstacles;
  };

  void work();
  void place() const;
  bool bringsToPlace(Located& map) const;
  std::optional<Pose2> globalFrom(const std::string& frame) const;

  const PlannerNodeOptions& options_;
  const tf2::BufferCore& buffer_;
  const std::optional<Footprint> footprint_;

  mutable std::mutex taking_mutex_;
  mutable std::condition_variable changed_;
  std::optional<PublishedMap> taken_;  // guarded by taking_mutex_, as the next three
  bool is_news_ = false;               // taken_ was not looked at yet
  bool busy_ = false;
  bool leaves_ = false;

  mutable std::mutex mutex_;
  mutable Located in_use_;   // guarded by mutex_, as the next one
  mutable Located waiting_;  // for a transform
  std::thread thread_;
};

}  // namespace hexapod
