#include "planning/move_path.h"

#include <algorithm>
#include <cmath>

#include "planning/path.h"

namespace hexapod {
namespace {

constexpr double kSpacing_m = 0.03;
// Whatever a repertoire claims; where that is absurdly far the points are farther apart.
constexpr double kMostPathPoints = 1000.0;

// What separates arcs from what is executed, at most, half-way: 2 cm and a tenth of the length. (Of
// the shipped robot: 3.5 cm in the median over entries, 5 cm at p90, 11 cm at most.)
constexpr double kBulge_m = 0.02;
constexpr double kBulge = 0.1;

/// The way with what its end differs from `end` added evenly.
std::vector<Pose2> bentTo(const Pose2& end, const std::vector<Pose2>& way) {
  const Pose2& last = way.back();
  const Pose2 off{end.x_m - last.x_m, end.y_m - last.y_m, wrapAngle(end.yaw_rad - last.yaw_rad)};
  std::vector<Pose2> bent = way;
  for (std::size_t i = 0; i < bent.size(); ++i) {
    const double share = static_cast<double>(i + 1) / static_cast<double>(bent.size());
    bent[i].x_m += share * off.x_m;
    bent[i].y_m += share * off.y_m;
    bent[i].yaw_rad += share * off.yaw_rad;
  }
  return bent;
}

}  // namespace

MovePath makeMovePath(const Pose2& start_from_end, const std::vector<Pose2>& way) {
  MovePath path;
  const double far_m = std::hypot(start_from_end.x_m, start_from_end.y_m);
  const double spacing_m = std::max(kSpacing_m, far_m / kMostPathPoints);
  const std::vector<Pose2> poses =
      way.empty() ? sampleStep(Pose2{}, start_from_end, spacing_m) : bentTo(start_from_end, way);
  const double bulge_m = way.empty() ? kBulge_m + kBulge * far_m : 0.0;
  path.points.reserve(poses.size() + 1);
  path.points.push_back({0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0});
  Pose2 before;
  for (const Pose2& pose : poses) {
    const MovePath::Point last = path.points.back();
    const double share = static_cast<double>(path.points.size()) / poses.size();
    path.points.push_back({pose.x_m, pose.y_m, std::cos(pose.yaw_rad), std::sin(pose.yaw_rad),
                           last.moved_m + distance(before, pose),
                           last.turned_rad + headingDistance(before, pose),
                           4.0 * share * (1.0 - share) * bulge_m});
    before = pose;
  }
  return path;
}

}  // namespace hexapod
