#include "geometry/pose2.h"

#include <cmath>

#include "common/text.h"

namespace hexapod {

double wrapAngle(double angle_rad) {
  const double wrapped = std::remainder(angle_rad, 2.0 * M_PI);
  return wrapped <= -M_PI ? M_PI : wrapped;
}

Pose2 operator*(const Pose2& a_from_b, const Pose2& b_from_c) {
  const double cosine = std::cos(a_from_b.yaw_rad);
  const double sine = std::sin(a_from_b.yaw_rad);
  return {a_from_b.x_m + cosine * b_from_c.x_m - sine * b_from_c.y_m,
          a_from_b.y_m + sine * b_from_c.x_m + cosine * b_from_c.y_m,
          wrapAngle(a_from_b.yaw_rad + b_from_c.yaw_rad)};
}

Pose2 inverse(const Pose2& a_from_b) {
  const double cosine = std::cos(a_from_b.yaw_rad);
  const double sine = std::sin(a_from_b.yaw_rad);
  return {-cosine * a_from_b.x_m - sine * a_from_b.y_m, sine * a_from_b.x_m - cosine * a_from_b.y_m,
          wrapAngle(-a_from_b.yaw_rad)};
}

double distance(const Pose2& a, const Pose2& b) { return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m); }

double headingDistance(const Pose2& a, const Pose2& b) {
  return std::abs(wrapAngle(a.yaw_rad - b.yaw_rad));
}

Eigen::Isometry3d inSpace(const Pose2& pose) {
  Eigen::Isometry3d isometry = Eigen::Isometry3d::Identity();
  isometry.translation() << pose.x_m, pose.y_m, 0.0;
  isometry.linear() = Eigen::AngleAxisd(pose.yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return isometry;
}

bool isFinite(const Pose2& pose) {
  return std::isfinite(pose.x_m) && std::isfinite(pose.y_m) && std::isfinite(pose.yaw_rad);
}

std::string poseText(const Pose2& pose) {
  return "(" + fixedText(pose.x_m, 2) + " m, " + fixedText(pose.y_m, 2) + " m, " +
         fixedText(pose.yaw_rad / kDegree, 0) + " deg)";
}

Pose2 footprint(const Eigen::Isometry3d& world_from_body) {
  const auto& rotation = world_from_body.linear();
  return {world_from_body.translation().x(), world_from_body.translation().y(),
          std::atan2(rotation(1, 0), rotation(0, 0))};
}

}  // namespace hexapod
