#pragma once

#include <Eigen/Geometry>
#include <string>

namespace hexapod {

/// A degree [rad].
constexpr double kDegree = M_PI / 180.0;

/// Wraps an angle [rad] into (-pi, pi]. Any finite input.
double wrapAngle(double angle_rad);

/// A pose in the plane: position [m] and heading [rad, counter-clockwise from +x].
/// REP-103 axes: x forward, y left. Named a_from_b, so that neighbours cancel:
/// world_from_start * start_from_end = world_from_end.
struct Pose2 {
  double x_m = 0.0;
  double y_m = 0.0;
  double yaw_rad = 0.0;
};

/// Composition; the heading of the result is wrapped into (-pi, pi].
Pose2 operator*(const Pose2& a_from_b, const Pose2& b_from_c);

/// b_from_a of a_from_b.
Pose2 inverse(const Pose2& a_from_b);

/// Distance between the two positions [m]; headings play no part.
double distance(const Pose2& a, const Pose2& b);

/// Smallest angle between the two headings, 0 .. pi [rad].
double headingDistance(const Pose2& a, const Pose2& b);

/// The pose in space, on the floor and upright.
Eigen::Isometry3d inSpace(const Pose2& pose);

/// True when all three coordinates are finite.
bool isFinite(const Pose2& pose);

/// For a sentence: "(0.50 m, -0.20 m, 34 deg)".
std::string poseText(const Pose2& pose);

/// The footprint of a body in space (REP-120 base_footprint): its position projected on the floor
/// and the heading of its x axis. At a pitch of +-90 degrees the heading is that of atan2(0, 0) =
/// 0.
Pose2 footprint(const Eigen::Isometry3d& world_from_body);

}  // namespace hexapod
