#include "evolution/k_means.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

#include "repertoire/metrics.h"
#include "repertoire/point_index.h"

namespace hexapod {
namespace {

// Some tens are enough; rounding could let two targets pass a point to each other for ever.
constexpr int kMostIterations = 1000;

double squaredDistance_m2(const Pose2& point, const Target& target) {
  const double dx = point.x_m - target.x_m;
  const double dy = point.y_m - target.y_m;
  return dx * dx + dy * dy;
}

Target targetAt(const Pose2& point) { return {point.x_m, point.y_m}; }

/// k-means++: each further seed is a point drawn in proportion to its squared distance from the
/// seeds so far.
std::vector<Target> seeds(const std::vector<Pose2>& points, std::size_t count, Random& random) {
  std::vector<Target> targets = {targetAt(points[random.below(points.size())])};
  std::vector<double> distances_m2(points.size(), std::numeric_limits<double>::infinity());
  while (targets.size() < count) {
    double sum_m2 = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      distances_m2[i] = std::min(distances_m2[i], squaredDistance_m2(points[i], targets.back()));
      sum_m2 += distances_m2[i];
    }
    double left_m2 = random.uniform() * sum_m2;
    std::size_t drawn = 0;
    while (drawn + 1 < points.size() && left_m2 >= distances_m2[drawn]) {
      left_m2 -= distances_m2[drawn++];
    }
    targets.push_back(targetAt(points[drawn]));
  }
  return targets;
}

/// The targets by position; of equally near ones the first counts as the nearest.
PointIndex indexOf(const std::vector<Target>& targets) {
  PointIndex index;
  for (std::size_t k = 0; k < targets.size(); ++k) {
    index.insert({{targets[k].x_m, targets[k].y_m, 0.0}, static_cast<std::int64_t>(k), k});
  }
  return index;
}

/// Moves every target to the mean of its points; one that has none stays.
void moveToMeans(const std::vector<Pose2>& points, const std::vector<std::size_t>& owners,
                 std::vector<Target>& targets) {
  std::vector<Target> sums(targets.size());
  std::vector<double> counts(targets.size(), 0.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    sums[owners[i]].x_m += points[i].x_m;
    sums[owners[i]].y_m += points[i].y_m;
    counts[owners[i]] += 1.0;
  }
  for (std::size_t k = 0; k < targets.size(); ++k) {
    if (counts[k] > 0.0) targets[k] = {sums[k].x_m / counts[k], sums[k].y_m / counts[k]};
  }
}

}  // namespace

std::vector<Target> kMeans(const std::vector<Pose2>& points, std::size_t count, Random random) {
  if (count == 0 || count > points.size()) {
    throw std::invalid_argument("K-means is asked for " + std::to_string(count) + " targets of " +
                                std::to_string(points.size()) + " points: expected 1 .. " +
                                std::to_string(points.size()) + ".");
  }
  std::vector<Target> targets = seeds(points, count, random);
  std::vector<std::size_t> owners(points.size(), count);
  bool moved = true;
  for (int iteration = 0; moved && iteration < kMostIterations; ++iteration) {
    moved = false;
    const PointIndex index = indexOf(targets);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::size_t owner = index.nearest(points[i], 1)[0].slot;
      moved = moved || owner != owners[i];
      owners[i] = owner;
    }
    if (moved) moveToMeans(points, owners, targets);
  }
  return targets;
}

double sparsenessOf(const std::vector<Pose2>& points, const std::vector<Target>& targets) {
  std::vector<Ending> endings;
  endings.reserve(targets.size());
  for (const Target& target : targets) endings.push_back({{target.x_m, target.y_m, 0.0}, 0.0});
  return median(distancesToNearest(points, endings)).value_or(0.0);
}

}  // namespace hexapod
