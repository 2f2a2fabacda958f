#include "tools/touch_check.h"

#include <algorithm>
#include <cmath>

#include "geometry/pose2.h"

namespace hexapod {

TouchCheck::TouchCheck(const OccupancyMap& map)
    : map_(map), map_from_world_(inverse(map.world_from_map)) {}

double TouchCheck::clearance_m(const Disc& world_disc, double around_m) const {
  const Pose2 at = map_from_world_ * Pose2{world_disc.x_m, world_disc.y_m, 0.0};
  const double side = map_.resolution_m;
  const double reach_m = world_disc.radius_m + around_m;
  const auto first_column = static_cast<int>(std::floor((at.x_m - reach_m) / side));
  const auto last_column = static_cast<int>(std::floor((at.x_m + reach_m) / side));
  const auto first_row = static_cast<int>(std::floor((at.y_m - reach_m) / side));
  const auto last_row = static_cast<int>(std::floor((at.y_m + reach_m) / side));
  double nearest_m = reach_m;
  for (int row = std::max(0, first_row); row <= std::min(map_.rows - 1, last_row); ++row) {
    for (int column = std::max(0, first_column); column <= std::min(map_.columns - 1, last_column);
         ++column) {
      if (map_.at(column, row) < OccupancyMap::kOccupied) continue;
      const double x = std::clamp(at.x_m, column * side, (column + 1) * side);
      const double y = std::clamp(at.y_m, row * side, (row + 1) * side);
      nearest_m = std::min(nearest_m, std::hypot(x - at.x_m, y - at.y_m));
    }
  }
  return nearest_m - world_disc.radius_m;
}

double TouchCheck::clearance_m(const Pose2& world_from_robot, const std::vector<Disc>& discs,
                               double around_m) const {
  double least_m = around_m;
  for (const Disc& disc : discs) {
    const Pose2 centre = world_from_robot * Pose2{disc.x_m, disc.y_m, 0.0};
    least_m = std::min(least_m, clearance_m({centre.x_m, centre.y_m, disc.radius_m}, around_m));
  }
  return least_m;
}

double TouchCheck::clearanceAlong_m(const std::vector<Pose2>& world_from_robots,
                                    const std::vector<Disc>& discs, double around_m) const {
  double least_m = around_m;
  for (std::size_t i = 1; i < world_from_robots.size(); ++i) {
    const Pose2& from = world_from_robots[i - 1];
    const Pose2& to = world_from_robots[i];
    const double turn_rad = wrapAngle(to.yaw_rad - from.yaw_rad);
    const int count =
        1 + static_cast<int>(distance(from, to) / 0.004 + std::abs(turn_rad) / kDegree);
    for (int k = 0; k <= count; ++k) {
      const double share = static_cast<double>(k) / count;
      const Pose2 pose{from.x_m + share * (to.x_m - from.x_m),
                       from.y_m + share * (to.y_m - from.y_m), from.yaw_rad + share * turn_rad};
      least_m = std::min(least_m, clearance_m(pose, discs, around_m));
    }
  }
  return least_m;
}

}  // namespace hexapod
