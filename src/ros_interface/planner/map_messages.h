#pragma once

#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/time.h>

#include <string>

#include "planning/occupancy_map.h"

namespace hexapod {

/// A map as it was published: `cells.world_from_map` is that in its own frame.
struct PublishedMap {
  std::string frame;  ///< without a slash; empty: the global one
  ros::Time stamp;
  OccupancyMap cells;
};

/// Reads a map; a sentence that says what is wrong with it, or "". Then `map` is as it was.
std::string readMap(const nav_msgs::OccupancyGrid& message, PublishedMap& map);

/// Whether both say the same of the same floor, whenever they were made.
bool isSameFloor(const PublishedMap& a, const PublishedMap& b);

/// What an update has come to.
struct MapUpdate {
  std::string problem;  ///< a sentence when it was refused
  bool changes = false;
};

/// Brings a rectangle of a map up to date. Refused, and the map as it was, when it is of another
/// frame, of another size than its values, not within the map, or older than the map: an update
/// names no resolution, so one meant for an earlier map is known by its stamp.
MapUpdate applyUpdate(const map_msgs::OccupancyGridUpdate& message, PublishedMap& map);

}  // namespace hexapod
