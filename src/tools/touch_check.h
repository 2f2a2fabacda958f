#pragma once

#include <cstddef>
#include <vector>

#include "geometry/footprint.h"
#include "planning/occupancy_map.h"

namespace hexapod {

/// How far around the footprint obstacles are looked for.
constexpr double kLookAround_m = 0.3;

/// Finds what a robot touches, from the occupied cells alone: it shares no code with the planner.
class TouchCheck {
 public:
  explicit TouchCheck(const OccupancyMap& map);

  /// Distance from a disc to the nearest occupied cell [m], looked for within `around_m` beyond its
  /// rim; negative: they overlap.
  double clearance_m(const Disc& world_disc, double around_m) const;

  /// The same for discs in the frame of a robot.
  double clearance_m(const Pose2& world_from_robot, const std::vector<Disc>& discs,
                     double around_m) const;

  /// Smallest clearance at poses less than 4 mm and 1 degree apart between those given.
  double clearanceAlong_m(const std::vector<Pose2>& world_from_robots,
                          const std::vector<Disc>& discs, double around_m) const;

 private:
  const OccupancyMap& map_;
  Pose2 map_from_world_;
};

}  // namespace hexapod
