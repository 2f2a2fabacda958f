#include "evolution/cells.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/text.h"
#include "evolution/k_means.h"
#include "repertoire/point_index.h"

namespace hexapod {
namespace {

// Points of the disk per centroid.
constexpr double kPointsPerCell = 10.0;
constexpr std::uint64_t kSeed = 1;

void requireLength(double length_m, const std::string& what) {
  if (length_m > 0.0 && std::isfinite(length_m)) return;
  throw std::invalid_argument("MAP-Elites has " + what + " of " + numberText(length_m) +
                              " m: expected more than 0.");
}

/// A square grid of so many points, or a few more, in the unit disk.
std::vector<Pose2> diskPoints(double count) {
  const auto rings = static_cast<int>(std::ceil(std::sqrt(count / M_PI)));
  std::vector<Pose2> points;
  for (int row = -rings; row <= rings; ++row) {
    for (int column = -rings; column <= rings; ++column) {
      if (row * row + column * column > rings * rings) continue;
      points.push_back(
          {column / static_cast<double>(rings), row / static_cast<double>(rings), 0.0});
    }
  }
  return points;
}

}  // namespace

Cells gridCells(double cell_m, const PoseMetric& metric) {
  requireLength(cell_m, "cells");
  const std::int64_t parts =
      std::max<std::int64_t>(1, std::llround(2.0 * M_PI * metric.heading_m_per_rad / cell_m));
  return [cell_m, parts](const Pose2& end) {
    const auto part = std::llround(end.yaw_rad / (2.0 * M_PI) * static_cast<double>(parts));
    return Cell{std::llround(end.x_m / cell_m), std::llround(end.y_m / cell_m),
                (part + parts) % parts};
  };
}

Cells voronoiCells(std::size_t count, double radius_m) {
  requireLength(radius_m, "a radius");
  if (count < 1) throw std::invalid_argument("MAP-Elites has 0 cells: expected 1 or more.");
  // In the unit disk, so that robots of all sizes have images of the same cells.
  const auto centroids = std::make_shared<PointIndex>();
  const std::vector<Pose2> points = diskPoints(kPointsPerCell * static_cast<double>(count));
  std::int64_t number = 0;
  for (const Target& centroid : kMeans(points, count, Random(kSeed))) {
    centroids->insert({{centroid.x_m, centroid.y_m, 0.0}, number++, 0});
  }
  return [centroids, radius_m](const Pose2& end) {
    const auto nearest = centroids->nearest({end.x_m / radius_m, end.y_m / radius_m, 0.0}, 1);
    return Cell{nearest[0].id};
  };
}

}  // namespace hexapod
