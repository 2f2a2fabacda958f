#include "planning/obstacles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace hexapod {
namespace {

const OccupancyMap& checked(const OccupancyMap& map) {
  const std::string problem = problemOf(map);
  if (!problem.empty()) throw std::invalid_argument(problem);
  return map;
}

/// A robot without a footprint is a point, of 1 mm so that being within something is not free.
Footprint orPoint(Footprint footprint) {
  if (footprint.discs.empty()) footprint.discs.push_back({0.0, 0.0, 0.001});
  return footprint;
}

double smallestOf(const Footprint& footprint) {
  double radius_m = std::numeric_limits<double>::infinity();
  for (const Disc& disc : footprint.discs) radius_m = std::min(radius_m, disc.radius_m);
  return radius_m;
}

}  // namespace

Obstacles::Obstacles(const OccupancyMap& map, const Footprint& footprint,
                     const ObstacleOptions& options)
    : Obstacles(map, footprint, options,
                std::make_shared<const DistanceField>(checked(map), options.unknown_is_free)) {
  ObstacleOptions narrow = options;
  narrow.footprint_margin_m = std::min(options.footprint_margin_m, options.narrow_margin_m);
  narrow_ = std::shared_ptr<const Obstacles>(new Obstacles(map, footprint, narrow, field_));
}

Obstacles::Obstacles(const OccupancyMap& map, const Footprint& footprint,
                     const ObstacleOptions& options, std::shared_ptr<const DistanceField> field)
    : options_(options),
      world_from_map_(map.world_from_map),
      cosine_(std::cos(map.world_from_map.yaw_rad)),
      sine_(std::sin(map.world_from_map.yaw_rad)),
      width_m_(map.columns * map.resolution_m),
      height_m_(map.rows * map.resolution_m),
      footprint_(orPoint(footprint).grownBy(options.footprint_margin_m)),
      inner_m_(footprint_.inner_m()),
      offset_m_(footprint_.offset_m()),
      smallest_m_(smallestOf(footprint_)),
      field_(std::move(field)) {}

Obstacles Obstacles::movedTo(const Pose2& world_from_map) const {
  Obstacles moved = *this;
  moved.moveTo(world_from_map);
  if (narrow_) moved.narrow_ = std::make_shared<const Obstacles>(narrow_->movedTo(world_from_map));
  return moved;
}

void Obstacles::moveTo(const Pose2& world_from_map) {
  world_from_map_ = world_from_map;
  cosine_ = std::cos(world_from_map.yaw_rad);
  sine_ = std::sin(world_from_map.yaw_rad);
}

Obstacles::Point Obstacles::mapFromWorld(double x_m, double y_m) const {
  const double x = x_m - world_from_map_.x_m;
  const double y = y_m - world_from_map_.y_m;
  return {cosine_ * x + sine_ * y, cosine_ * y - sine_ * x};
}

/// Of the footprint at a position and heading in the map.
double Obstacles::room(double x_m, double y_m, double cosine, double sine) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Disc& disc : footprint_.discs) {
    const double x = x_m + cosine * disc.x_m - sine * disc.y_m;
    const double y = y_m + sine * disc.x_m + cosine * disc.y_m;
    least = std::min(least, field_->atLeast(x, y) - disc.radius_m);
  }
  return least;
}

double Obstacles::clearance_m(const Pose2& world_from_robot) const {
  const Point at = mapFromWorld(world_from_robot.x_m, world_from_robot.y_m);
  const double yaw = world_from_robot.yaw_rad - world_from_map_.yaw_rad;
  return room(at.x_m, at.y_m, std::cos(yaw), std::sin(yaw));
}

/// Room at points of a path that begins at a pose of the world.
class Obstacles::Along {
 public:
  Along(const Obstacles& obstacles, const Pose2& world_from_start)
      : obstacles_(obstacles),
        start_(obstacles.mapFromWorld(world_from_start.x_m, world_from_start.y_m)) {
    const double yaw_rad = world_from_start.yaw_rad - obstacles.world_from_map_.yaw_rad;
    cosine_ = std::cos(yaw_rad);
    sine_ = std::sin(yaw_rad);
  }

  double room_m(const MovePath::Point& p) const {
    return obstacles_.room(start_.x_m + cosine_ * p.x_m - sine_ * p.y_m,
                           start_.y_m + sine_ * p.x_m + cosine_ * p.y_m,
                           cosine_ * p.cosine - sine_ * p.sine,
                           sine_ * p.cosine + cosine_ * p.sine) -
           p.bulge_m;
  }
  /// No part of the footprint has come farther since the start.
  double moved_m(const MovePath::Point& p) const {
    return p.moved_m + obstacles_.offset_m_ * p.turned_rad;
  }

 private:
  const Obstacles& obstacles_;
  Point start_;
  double cosine_;
  double sine_;
};

// Where two points of the path have rooms a and b, a way of length l between them keeps at least
// (a + b - l) / 2. Points within the room of one before need not be looked at; those that follow
// each other are near enough for the way between them to be straight, and then it keeps at least
// min(a, b) - l^2 / 4 r beside discs of radius r, as the square of the distance to what is occupied
// bends no more than that of the position. A robot that leaves its margin has no room to begin
// with: its first few centimetres are judged by their end.
bool Obstacles::isFree(const Pose2& world_from_start, const MovePath& path, double least_m) const {
  const Along along(*this, world_from_start);
  const std::vector<MovePath::Point>& points = path.points;
  const double radius_m = std::max(1e-6, smallest_m_ + least_m);
  double moved_m = 0.0;
  double spare_m = along.room_m(points.front()) - least_m;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double sure_m = moved_m + spare_m;
    const bool last = i + 1 == points.size();
    if (!last && along.moved_m(points[i + 1]) <= sure_m) continue;
    const double before_m = std::exchange(moved_m, along.moved_m(points[i]));
    const double before_spare_m = std::exchange(spare_m, along.room_m(points[i]) - least_m);
    const double length_m = moved_m - before_m;
    const bool leaving = i == 1 && least_m < 0.0;
    if (spare_m < 0.0) return false;
    if (leaving || moved_m - spare_m <= sure_m) continue;
    if (std::min(before_spare_m, spare_m) < 0.25 * length_m * length_m / radius_m) return false;
  }
  return true;
}

double Obstacles::clearance_m(const Pose2& world_from_start, const MovePath& path) const {
  const Along along(*this, world_from_start);
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    least_m = std::min(least_m, along.room_m(path.points[i]));
  }
  return least_m;
}

}  // namespace hexapod
