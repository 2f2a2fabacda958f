#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "robot/robot_description.h"

namespace hexapod {

/// A leg at some angles, in the frame of the base.
struct LegPose {
  std::vector<Eigen::Vector3d> joint_m;  ///< where the hinges are
  std::vector<Eigen::Vector3d> axis;     ///< their axes
  Eigen::Vector3d foot_m;                ///< centre of the foot
  double floor_m;                        ///< height of the foot's lowest point
  double lowest_of_others_m;             ///< of everything but the foot
  Eigen::Matrix3Xd jacobian_m;           ///< d foot / d angle
};

/// Kinematics of one leg. Its foot is that point of its last shapes which is farthest from its last
/// joint; of a box the middle of the corners that are about as far. The leg must outlive it.
class LegModel {
 public:
  explicit LegModel(const Leg& leg);

  const Leg& leg() const { return leg_; }
  std::size_t jointCount() const { return leg_.segments.size(); }
  double reach_m() const { return reach_m_; }
  Eigen::Vector3d hip_m() const {
    return leg_.segments.front().joint.parent_from_joint.translation();
  }

  LegPose at(const std::vector<double>& angles_rad) const;

 private:
  bool isOfFoot(const Eigen::Vector3d& point) const;
  void takeFoot(const Eigen::Isometry3d& base_from_body, LegPose& pose) const;

  const Leg& leg_;
  double reach_m_;
  std::size_t foot_segment_ = 0;
  std::vector<Eigen::Vector3d> foot_points_;        // in its body, less the radius
  Eigen::Vector3d foot_ = Eigen::Vector3d::Zero();  // their middle
  double foot_radius_m_ = 0.0;
};

}  // namespace hexapod
