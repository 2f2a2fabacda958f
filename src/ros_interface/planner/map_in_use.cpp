#include "ros_interface/planner/map_in_use.h"

#include <tf2/exceptions.h>

#include <exception>

#include "ros_interface/common/conversions.h"

namespace hexapod {
namespace {

// Smaller changes of the transform are not worth planning anew.
constexpr double kSame_m = 0.002;
constexpr double kSame_rad = 0.001;

bool isSame(const Pose2& a, const Pose2& b) {
  return distance(a, b) < kSame_m && headingDistance(a, b) < kSame_rad;
}

OccupancyMap fromMsg(const nav_msgs::OccupancyGrid& message, const Pose2& global_from_map) {
  OccupancyMap map;
  map.world_from_map = global_from_map;
  map.resolution_m = message.info.resolution;
  map.columns = static_cast<int>(message.info.width);
  map.rows = static_cast<int>(message.info.height);
  map.cells = message.data;
  return map;
}

}  // namespace

MapInUse::MapInUse(const PlannerNodeOptions& options, const tf2::BufferCore& buffer,
                   const std::optional<Footprint>& footprint)
    : options_(options), buffer_(buffer), footprint_(footprint) {
  if (options.footprint_radius_m > 0.0) {
    footprint_ = Footprint{{{0.0, 0.0, options.footprint_radius_m}}};
  }
}

std::string MapInUse::take(const nav_msgs::OccupancyGrid& message) {
  if (!footprint_) {
    return "The map is refused: how much floor the robot needs is not known; set ~robot_config or "
           "~footprint_radius_m.";
  }
  std::string problem;
  const std::optional<Pose2> frame_from_map = fromPoseMsg(message.info.origin, problem);
  if (!frame_from_map) return "The map is refused: of its origin, " + problem + ".";
  try {
    auto obstacles = std::make_shared<const Obstacles>(fromMsg(message, *frame_from_map),
                                                       *footprint_, options_.obstacles);
    const std::lock_guard<std::mutex> lock(mutex_);
    frame_ = message.header.frame_id;
    frame_from_map_ = *frame_from_map;
    obstacles_ = std::move(obstacles);
  } catch (const std::exception& error) {
    return std::string("The map is refused: ") + error.what();
  }
  return "";
}

/// The last known transform stays in use while tf has none.
std::optional<Pose2> MapInUse::globalFromFrame() const {
  if (frame_.empty() || frame_ == options_.global_frame) return Pose2{};
  try {
    const geometry_msgs::Transform transform =
        buffer_.lookupTransform(options_.global_frame, frame_, ros::Time(0)).transform;
    geometry_msgs::Pose pose;
    pose.position.x = transform.translation.x;
    pose.position.y = transform.translation.y;
    pose.orientation = transform.rotation;
    std::string problem;
    return fromPoseMsg(pose, problem);
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

std::shared_ptr<const Obstacles> MapInUse::obstacles() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!obstacles_) return nullptr;
  const std::optional<Pose2> global_from_frame = globalFromFrame();
  if (!global_from_frame) return obstacles_;
  const Pose2 global_from_map = *global_from_frame * frame_from_map_;
  if (!isSame(global_from_map, obstacles_->worldFromMap())) {
    obstacles_ = std::make_shared<const Obstacles>(obstacles_->movedTo(global_from_map));
  }
  return obstacles_;
}

}  // namespace hexapod
