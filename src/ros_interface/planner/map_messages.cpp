#include "ros_interface/planner/map_messages.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "ros_interface/common/conversions.h"

namespace hexapod {
namespace {

std::string withoutSlash(const std::string& frame) {
  return frame.empty() || frame.front() != '/' ? frame : frame.substr(1);
}

std::string size(std::int64_t columns, std::int64_t rows) {
  return std::to_string(columns) + " x " + std::to_string(rows);
}

/// Why an update cannot be one of that map, or "".
std::string whyNotOf(const map_msgs::OccupancyGridUpdate& update, const PublishedMap& map) {
  const std::string frame = withoutSlash(update.header.frame_id);
  if (!frame.empty() && frame != map.frame) {
    return "is in the frame '" + frame + "', the map in '" + map.frame +
           "': publish both in the same frame";
  }
  if (!update.header.stamp.isZero() && update.header.stamp < map.stamp) {
    return "is older than the map: it belongs to an earlier one";
  }
  const std::uint64_t cells = std::uint64_t{update.width} * update.height;
  if (update.data.size() != cells) {
    return "of " + size(update.width, update.height) + " cells comes with " +
           std::to_string(update.data.size()) + " values instead of " + std::to_string(cells);
  }
  const std::int64_t last_column = std::int64_t{update.x} + update.width;
  const std::int64_t last_row = std::int64_t{update.y} + update.height;
  if (update.x >= 0 && update.y >= 0 && last_column <= map.cells.columns &&
      last_row <= map.cells.rows) {
    return "";
  }
  return "of " + size(update.width, update.height) + " cells at column " +
         std::to_string(update.x) + " and row " + std::to_string(update.y) +
         " is not within the map of " + size(map.cells.columns, map.cells.rows) +
         ": publish the whole map when its size or resolution changes";
}

}  // namespace

std::string readMap(const nav_msgs::OccupancyGrid& message, PublishedMap& map) {
  std::string problem;
  const auto frame_from_map = fromPoseMsg(message.info.origin, problem);
  if (!frame_from_map) return "The map is refused: of its origin, " + problem + ".";
  PublishedMap read;
  read.frame = withoutSlash(message.header.frame_id);
  read.stamp = message.header.stamp;
  read.cells.world_from_map = *frame_from_map;
  read.cells.resolution_m = message.info.resolution;
  read.cells.columns = static_cast<int>(message.info.width);
  read.cells.rows = static_cast<int>(message.info.height);
  read.cells.cells = message.data;
  problem = problemOf(read.cells);
  if (!problem.empty()) return "The map is refused: " + problem;
  map = std::move(read);
  return "";
}

bool isSameFloor(const PublishedMap& a, const PublishedMap& b) {
  const Pose2& at = a.cells.world_from_map;
  const Pose2& other = b.cells.world_from_map;
  return a.frame == b.frame && at.x_m == other.x_m && at.y_m == other.y_m &&
         at.yaw_rad == other.yaw_rad && a.cells.resolution_m == b.cells.resolution_m &&
         a.cells.columns == b.cells.columns && a.cells.rows == b.cells.rows &&
         a.cells.cells == b.cells.cells;
}

MapUpdate applyUpdate(const map_msgs::OccupancyGridUpdate& message, PublishedMap& map) {
  MapUpdate update;
  const std::string why = whyNotOf(message, map);
  if (!why.empty()) {
    update.problem = "An update of the map is refused: it " + why + ".";
    return update;
  }
  for (std::uint32_t row = 0; row < message.height; ++row) {
    const auto from = message.data.begin() + static_cast<std::ptrdiff_t>(row) * message.width;
    const auto to = map.cells.cells.begin() +
                    (static_cast<std::ptrdiff_t>(message.y) + row) * map.cells.columns + message.x;
    if (std::equal(from, from + message.width, to)) continue;
    std::copy(from, from + message.width, to);
    update.changes = true;
  }
  return update;
}

}  // namespace hexapod
