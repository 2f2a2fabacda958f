#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <tf2/buffer_core.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "planning/obstacles.h"
#include "ros_interface/planner/planner_node_options.h"

namespace hexapod {

/// The newest map and what it means for the robot, brought into the global frame as tf says at the
/// time of asking. From any thread; take() by one at a time.
class MapInUse {
 public:
  /// `footprint` without margin, nothing when the robot is not known. Both references must outlive
  /// it.
  MapInUse(const PlannerNodeOptions& options, const tf2::BufferCore& buffer,
           const std::optional<Footprint>& footprint);

  /// Takes a map in use, which may take a while. Empty, or a sentence that says why it is not.
  std::string take(const nav_msgs::OccupancyGrid& message);

  /// Null as long as there is no map. The same object as long as nothing has changed.
  std::shared_ptr<const Obstacles> obstacles() const;

 private:
  std::optional<Pose2> globalFromFrame() const;

  const PlannerNodeOptions& options_;
  const tf2::BufferCore& buffer_;
  std::optional<Footprint> footprint_;
  mutable std::mutex mutex_;
  // Guarded by mutex_.
  std::string frame_;
  Pose2 frame_from_map_;
  mutable std::shared_ptr<const Obstacles> obstacles_;
};

}  // namespace hexapod
