#include "robot_import/leg_model.h"

#include <algorithm>
#include <limits>

#include "robot/dimensions.h"
#include "robot_import/fit_shape.h"

namespace hexapod {

namespace {

// Within a tenth of the farthest from the joint.
Points farCorners(const Shape& box) {
  constexpr double kShare = 0.9;
  double farthest_m = 0.0;
  for (const Eigen::Vector3d& corner : corePoints(box)) {
    farthest_m = std::max(farthest_m, corner.norm());
  }
  Points far;
  for (const Eigen::Vector3d& corner : corePoints(box)) {
    if (corner.norm() >= kShare * farthest_m) far.push_back(corner);
  }
  return far;
}

}  // namespace

LegModel::LegModel(const Leg& leg) : leg_(leg), reach_m_(hexapod::reach_m(leg)) {
  for (std::size_t s = 0; s < leg.segments.size(); ++s) {
    if (!leg.segments[s].body.shapes.empty()) foot_segment_ = s;
  }
  double farthest_m = -1.0;
  for (const Shape& shape : leg.segments[foot_segment_].body.shapes) {
    for (const Eigen::Vector3d& core : corePoints(shape)) {
      if (core.norm() + roundness_m(shape) <= farthest_m) continue;
      farthest_m = core.norm() + roundness_m(shape);
      foot_points_ = {core};
      if (shape.kind == Shape::Kind::kBox) foot_points_ = farCorners(shape);
      foot_radius_m_ = roundness_m(shape);
    }
  }
  for (const Eigen::Vector3d& point : foot_points_) {
    foot_ += point / static_cast<double>(foot_points_.size());
  }
}

bool LegModel::isOfFoot(const Eigen::Vector3d& point) const {
  return (point - foot_).norm() < 0.1 * reach_m_ ||
         std::find(foot_points_.begin(), foot_points_.end(), point) != foot_points_.end();
}

void LegModel::takeFoot(const Eigen::Isometry3d& base_from_body, LegPose& pose) const {
  pose.foot_m = base_from_body * foot_;
  pose.floor_m = pose.foot_m.z() - foot_radius_m_;
  for (const Eigen::Vector3d& point : foot_points_) {
    pose.floor_m = std::min(pose.floor_m, (base_from_body * point).z() - foot_radius_m_);
  }
}

LegPose LegModel::at(const std::vector<double>& angles_rad) const {
  LegPose pose;
  pose.lowest_of_others_m = std::numeric_limits<double>::infinity();
  Eigen::Isometry3d base_from_body = Eigen::Isometry3d::Identity();
  for (std::size_t s = 0; s < leg_.segments.size(); ++s) {
    const auto& [joint, body] = leg_.segments[s];
    base_from_body = base_from_body * joint.parent_from_joint;
    pose.joint_m.push_back(base_from_body.translation());
    pose.axis.push_back(base_from_body.linear() * joint.axis);
    base_from_body = base_from_body * Eigen::AngleAxisd(angles_rad[s], joint.axis);
    if (s == foot_segment_) takeFoot(base_from_body, pose);
    for (const Shape& shape : body.shapes) {
      for (const Eigen::Vector3d& core : corePoints(shape)) {
        if (s == foot_segment_ && isOfFoot(core)) continue;
        pose.lowest_of_others_m =
            std::min(pose.lowest_of_others_m, (base_from_body * core).z() - roundness_m(shape));
      }
    }
  }
  pose.jacobian_m = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(leg_.segments.size()));
  for (std::size_t s = 0; s <= foot_segment_; ++s) {
    pose.jacobian_m.col(static_cast<Eigen::Index>(s)) =
        pose.axis[s].cross(pose.foot_m - pose.joint_m[s]);
  }
  return pose;
}

}  // namespace hexapod
