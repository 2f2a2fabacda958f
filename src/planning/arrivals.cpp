#include "planning/arrivals.h"

#include <cmath>

namespace hexapod {
namespace {

constexpr int kHeadings = 8;
// Less is not worth a choice.
constexpr double kLeastChoice_rad = 0.1;
constexpr double kLeastChoice_m = 0.1;

/// The waypoint with each part of its headings.
void addHeadings(const Waypoint& waypoint, double onward_rad, std::vector<Waypoint>& arrivals) {
  const double yaw_rad = waypoint.tolerance.yaw_rad;
  const auto add = [&](double heading_rad, double half_width_rad) {
    Waypoint arrival = waypoint;
    arrival.world_from_goal.yaw_rad = wrapAngle(heading_rad);
    arrival.tolerance.yaw_rad = half_width_rad;
    arrivals.push_back(arrival);
  };
  if (waypoint.tolerance.anyHeading()) {
    for (int i = 0; i < kHeadings; ++i) {
      add(onward_rad + 2.0 * M_PI / kHeadings * i, M_PI / kHeadings);
    }
  } else if (yaw_rad >= kLeastChoice_rad) {
    for (const double side : {-0.5, 0.5}) {
      add(waypoint.world_from_goal.yaw_rad + side * yaw_rad, 0.5 * yaw_rad);
    }
  }
}

}  // namespace

std::vector<Waypoint> arrivalsAt(const Waypoint& waypoint, double onward_rad) {
  std::vector<Waypoint> arrivals;
  addHeadings(waypoint, onward_rad, arrivals);
  if (waypoint.tolerance.xy_m < kLeastChoice_m) return arrivals;
  Waypoint nearer = waypoint;
  nearer.tolerance.xy_m *= 0.5;
  nearer.world_from_goal.x_m += nearer.tolerance.xy_m * std::cos(onward_rad);
  nearer.world_from_goal.y_m += nearer.tolerance.xy_m * std::sin(onward_rad);
  arrivals.push_back(nearer);
  addHeadings(nearer, onward_rad, arrivals);
  return arrivals;
}

}  // namespace hexapod
