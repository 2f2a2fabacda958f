#include "ros_interface/planner/map_in_use.h"

#include <tf2/exceptions.h>

#include <utility>

#include "ros_interface/common/conversions.h"
#include "ros_interface/common/realtime.h"

namespace hexapod {
namespace {

// Smaller changes of the transform are not worth planning anew.
constexpr double kSame_m = 0.002;
constexpr double kSame_rad = 0.001;

bool isSame(const Pose2& a, const Pose2& b) {
  return distance(a, b) < kSame_m && headingDistance(a, b) < kSame_rad;
}

// The user's word, or what is known of the robot.
std::optional<Footprint> footprintOf(const PlannerNodeOptions& options,
                                     const std::optional<Footprint>& known) {
  if (options.footprint_radius_m <= 0.0) return known;
  return Footprint{{{0.0, 0.0, options.footprint_radius_m}}};
}

}  // namespace

MapInUse::MapInUse(const PlannerNodeOptions& options, const tf2::BufferCore& buffer,
                   const std::optional<Footprint>& footprint)
    : options_(options), buffer_(buffer), footprint_(footprintOf(options, footprint)) {
  thread_ = std::thread(&MapInUse::work, this);
}

MapInUse::~MapInUse() {
  {
    const std::lock_guard<std::mutex> lock(taking_mutex_);
    leaves_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

std::string MapInUse::take(const nav_msgs::OccupancyGrid& message) {
  if (!footprint_) {
    return "The map is refused: how much floor the robot needs is not known; set ~robot_config or "
           "~footprint_radius_m.";
  }
  PublishedMap map;
  std::string problem = readMap(message, map);
  if (!problem.empty()) return problem;
  const std::lock_guard<std::mutex> lock(taking_mutex_);
  // The same again leaves plans and what they remember of the ways as they are.
  const bool changes = !taken_ || !isSameFloor(map, *taken_);
  taken_ = std::move(map);
  if (!changes) return "";
  is_news_ = true;
  changed_.notify_all();
  return "";
}

std::string MapInUse::take(const map_msgs::OccupancyGridUpdate& message) {
  const std::lock_guard<std::mutex> lock(taking_mutex_);
  if (!taken_) return "An update of the map is refused: no map has come before it.";
  MapUpdate update = applyUpdate(message, *taken_);
  if (update.changes) {
    is_news_ = true;
    changed_.notify_all();
  }
  return std::move(update.problem);
}

void MapInUse::settle() const {
  std::unique_lock<std::mutex> lock(taking_mutex_);
  changed_.wait(lock, [this] { return !is_news_ && !busy_; });
}

void MapInUse::work() {
  beLessUrgent(Niceness::kThinking);
  for (;;) {
    PublishedMap map;
    {
      std::unique_lock<std::mutex> lock(taking_mutex_);
      busy_ = false;
      changed_.notify_all();
      changed_.wait(lock, [this] { return is_news_ || leaves_; });
      if (leaves_) return;
      map = *taken_;
      is_news_ = false;
      busy_ = true;
    }
    auto obstacles = std::make_shared<const Obstacles>(map.cells, *footprint_, options_.obstacles);
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_ = {map.frame, map.cells.world_from_map, std::move(obstacles)};
    place();
  }
}

std::optional<Pose2> MapInUse::globalFrom(const std::string& frame) const {
  if (frame.empty() || frame == options_.pose.global_frame) return Pose2{};
  try {
    const geometry_msgs::Transform transform =
        buffer_.lookupTransform(options_.pose.global_frame, frame, ros::Time(0)).transform;
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

/// Takes a map that waits as soon as tf knows its frame; the last known transform of the one in use
/// stays while tf has none. With mutex_.
void MapInUse::place() const {
  if (bringsToPlace(waiting_)) {
    in_use_ = std::exchange(waiting_, {});
  } else {
    bringsToPlace(in_use_);
  }
}

/// Moves a map to where tf says; false when there is none or tf does not know its frame.
bool MapInUse::bringsToPlace(Located& map) const {
  if (!map.obstacles) return false;
  const std::optional<Pose2> global_from_frame = globalFrom(map.frame);
  if (!global_from_frame) return false;
  const Pose2 global_from_map = *global_from_frame * map.frame_from_map;
  if (!isSame(global_from_map, map.obstacles->worldFromMap())) {
    map.obstacles = std::make_shared<const Obstacles>(map.obstacles->movedTo(global_from_map));
  }
  return true;
}

std::shared_ptr<const Obstacles> MapInUse::obstacles() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  place();
  return in_use_.obstacles;
}

std::string MapInUse::problem() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  place();
  if (!waiting_.obstacles) return "";
  return "tf does not say where the frame of the map, " + waiting_.frame + ", lies in " +
         options_.pose.global_frame + "; publish that transform, or the map in a frame of the tf " +
         "tree.";
}

}  // namespace hexapod
