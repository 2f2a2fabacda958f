#include "repertoire/metrics.h"

#include <algorithm>
#include <cmath>

#include "geometry/arc.h"
#include "repertoire/point_index.h"

namespace hexapod {

std::vector<Ending> learnedEndings(const std::vector<Entry>& entries) {
  std::vector<Ending> endings;
  endings.reserve(entries.size());
  for (const Entry& entry : entries) {
    endings.push_back({entry.end_pose, entry.orientationErrorRad()});
  }
  return endings;
}

std::vector<Ending> expectedEndings(const std::vector<Entry>& entries) {
  std::vector<Ending> endings;
  endings.reserve(entries.size());
  for (const Entry& entry : entries) {
    if (!entry.usable()) continue;
    endings.push_back({entry.expectedPose(), orientationError(entry.expectedPose())});
  }
  return endings;
}

RegionOfInterest RegionOfInterest::scaledBy(double length_scale) const {
  return {half_angle_rad, length_scale * arc_length_m, length_scale * grid_step_m};
}

bool RegionOfInterest::contains(double x_m, double y_m) const {
  if (x_m == 0.0 && y_m == 0.0) return true;
  const double polar_rad = std::atan2(std::abs(y_m), std::abs(x_m));
  return polar_rad <= half_angle_rad && std::abs(arcThrough(x_m, y_m).length_m) < arc_length_m;
}

std::vector<Pose2> RegionOfInterest::grid() const {
  // No point of an arc is farther away than the arc is long.
  const int reach = static_cast<int>(std::ceil(arc_length_m / grid_step_m));
  std::vector<Pose2> points;
  for (int row = -reach; row <= reach; ++row) {
    for (int column = -reach; column <= reach; ++column) {
      const Pose2 point{column * grid_step_m, row * grid_step_m, 0.0};
      if (contains(point.x_m, point.y_m)) points.push_back(point);
    }
  }
  return points;
}

std::vector<double> distancesToNearest(const std::vector<Pose2>& positions,
                                       const std::vector<Ending>& endings) {
  if (endings.empty()) return {};
  PointIndex index;
  for (std::size_t slot = 0; slot < endings.size(); ++slot) {
    index.insert({endings[slot].pose, static_cast<std::int64_t>(slot), slot});
  }
  std::vector<double> distances;
  distances.reserve(positions.size());
  for (const Pose2& position : positions) {
    const auto nearest = index.nearest(position, 1);
    distances.push_back(std::sqrt(nearest.front().squared_distance_m2));
  }
  return distances;
}

std::optional<double> median(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

RepertoireMetrics measure(const std::vector<Ending>& endings, const RegionOfInterest& region) {
  const std::vector<Pose2> grid = region.grid();
  RepertoireMetrics metrics;
  std::vector<double> errors_of_all;
  std::vector<double> errors_in_region;
  for (const Ending& ending : endings) {
    errors_of_all.push_back(ending.orientation_error_rad);
    if (region.contains(ending.pose.x_m, ending.pose.y_m)) {
      errors_in_region.push_back(ending.orientation_error_rad);
    }
    metrics.max_reach_m =
        std::max(metrics.max_reach_m, std::hypot(ending.pose.x_m, ending.pose.y_m));
  }
  metrics.endings = errors_of_all.size();
  metrics.endings_in_region = errors_in_region.size();
  metrics.sparseness_m = median(distancesToNearest(grid, endings)).value_or(0.0);
  metrics.median_error_of_all_rad = median(errors_of_all).value_or(0.0);
  metrics.median_error_in_region_rad = median(errors_in_region).value_or(0.0);
  const double cell_dm2 = 100.0 * region.grid_step_m * region.grid_step_m;
  if (!grid.empty()) {
    metrics.density_in_region_per_dm2 = static_cast<double>(metrics.endings_in_region) /
                                        (static_cast<double>(grid.size()) * cell_dm2);
  }
  return metrics;
}

}  // namespace hexapod
