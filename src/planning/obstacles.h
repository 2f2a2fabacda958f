#pragma once

#include <memory>

#include "geometry/footprint.h"
#include "planning/distance_field.h"
#include "planning/move_path.h"
#include "planning/occupancy_map.h"

namespace hexapod {

/// Which cells count as occupied, and how much room the robot wants.
struct ObstacleOptions {
  bool unknown_is_free = true;       ///< of cells never seen and of everything beyond the map
  double footprint_margin_m = 0.03;  ///< kept between footprint and occupied cells
  double narrow_margin_m = 0.01;     ///< kept where that leaves no way; at most the other
};

/// The floor that a robot of some footprint may be on. Immutable; may be read from any thread.
///
/// Answers are on the safe side: where it says free, footprint and margin touch no occupied cell,
/// all along a path.
class Obstacles {
 public:
  /// `footprint` without margin. Throws std::invalid_argument with problemOf(map).
  Obstacles(const OccupancyMap& map, const Footprint& footprint, const ObstacleOptions& options);

  /// The same with narrow_margin_m for the margin.
  const std::shared_ptr<const Obstacles>& narrow() const { return narrow_; }

  /// The same map at another place.
  Obstacles movedTo(const Pose2& world_from_map) const;

  /// Room between the footprint with its margin and what is occupied, at least [m]; negative: not
  /// free.
  double clearance_m(const Pose2& world_from_robot) const;
  bool isFree(const Pose2& world_from_robot) const { return clearance_m(world_from_robot) >= 0.0; }

  /// The least at the points of a path, its start left out.
  double clearance_m(const Pose2& world_from_start, const MovePath& path) const;
  /// Whether the clearance along a path is nowhere less than `least_m`, which is negative for a
  /// robot that stands within its margin and wants to leave.
  bool isFree(const Pose2& world_from_start, const MovePath& path, double least_m = 0.0) const;

  /// A point of the map, in its frame.
  struct Point {
    double x_m, y_m;
  };
  Point mapFromWorld(double world_x_m, double world_y_m) const;

  /// Bounds of the room around base_footprint beyond the inner disc of the footprint: where the
  /// upper one is negative the robot can be with no heading at all.
  double leastRoom_m(const Point& at) const { return field_->atLeast(at.x_m, at.y_m) - inner_m_; }
  double mostRoom_m(const Point& at) const { return field_->atMost(at.x_m, at.y_m) - inner_m_; }
  /// Radius of that inner disc, margin included [m].
  double innerRadius_m() const { return inner_m_; }

  const Pose2& worldFromMap() const { return world_from_map_; }
  double width_m() const { return width_m_; }
  double height_m() const { return height_m_; }
  const ObstacleOptions& options() const { return options_; }

 private:
  class Along;

  Obstacles(const OccupancyMap& map, const Footprint& footprint, const ObstacleOptions& options,
            std::shared_ptr<const DistanceField> field);
  void moveTo(const Pose2& world_from_map);

  double room(double x_m, double y_m, double cosine, double sine) const;

  ObstacleOptions options_;
  Pose2 world_from_map_;
  double cosine_;  ///< of world_from_map
  double sine_;
  double width_m_;
  double height_m_;
  Footprint footprint_;  ///< with margin
  double inner_m_;
  double offset_m_;
  double smallest_m_;  ///< radius of its smallest disc
  std::shared_ptr<const DistanceField> field_;
  std::shared_ptr<const Obstacles> narrow_;  ///< null in one that is narrow itself
};

}  // namespace hexapod
