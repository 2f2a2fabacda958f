#include "planning/path.h"

#include <algorithm>
#include <cmath>

#include "geometry/arc.h"

namespace hexapod {
namespace {

constexpr double kHeadingSpacing_rad = M_PI / 18.0;
constexpr double kOffArc_rad = M_PI / 3.0;

}  // namespace

std::vector<Pose2> sampleStep(const Pose2& world_from_start, const Pose2& start_from_end,
                              double spacing_m) {
  Arc arc = arcThrough(start_from_end.x_m, start_from_end.y_m);
  double off_arc_rad = wrapAngle(start_from_end.yaw_rad - arc.heading_rad);
  double length_m = std::abs(arc.length_m);
  const bool on_arc = std::abs(off_arc_rad) <= kOffArc_rad;
  if (!on_arc) {
    off_arc_rad = wrapAngle(start_from_end.yaw_rad);
    length_m = std::hypot(start_from_end.x_m, start_from_end.y_m);
  }
  const double turned_rad = on_arc ? arc.curvature_per_m * arc.length_m + off_arc_rad : off_arc_rad;
  const int count =
      std::max({1, static_cast<int>(std::ceil(length_m / spacing_m)),
                static_cast<int>(std::ceil(std::abs(turned_rad) / kHeadingSpacing_rad))});
  std::vector<Pose2> poses;
  poses.reserve(static_cast<std::size_t>(count));
  for (int i = 1; i < count; ++i) {
    const double fraction = static_cast<double>(i) / count;
    Pose2 pose = on_arc ? arc.at(fraction)
                        : Pose2{fraction * start_from_end.x_m, fraction * start_from_end.y_m, 0.0};
    pose.yaw_rad += fraction * off_arc_rad;
    poses.push_back(world_from_start * pose);
  }
  poses.push_back(world_from_start * start_from_end);
  return poses;
}

std::vector<Pose2> samplePath(const Pose2& world_from_start,
                              const std::vector<Pose2>& world_from_ends, double spacing_m) {
  std::vector<Pose2> path = {world_from_start};
  for (const Pose2& world_from_end : world_from_ends) {
    const Pose2 from = path.back();
    const std::vector<Pose2> step = sampleStep(from, inverse(from) * world_from_end, spacing_m);
    path.insert(path.end(), step.begin(), step.end());
  }
  return path;
}

}  // namespace hexapod
