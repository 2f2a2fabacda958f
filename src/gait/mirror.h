#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "gait/symmetry.h"
#include "robot/robot_description.h"

namespace hexapod {

/// A reflection of space, or a half turn about z, applied to a robot in its neutral pose: looks
/// whether the image is the robot again. See symmetriesOf().
class Mirror {
 public:
  Mirror(double x_sign, double y_sign) : flip_(x_sign, y_sign, 1.0) {}

  /// The image of each leg, or nothing when the image is another robot.
  std::optional<std::vector<Symmetry::LegImage>> legImages(const RobotDescription& robot) const;

 private:
  std::optional<Symmetry::LegImage> legImage(const Leg& leg, const Leg& other) const;
  bool jointsMatch(const Joint& joint, const Joint& other, double sense) const;
  bool bodiesMatch(const Body& body, const Eigen::Isometry3d& base_from_body, const Body& other,
                   const Eigen::Isometry3d& base_from_other) const;
  bool shapesMatch(const Shape& shape, const Eigen::Isometry3d& base_from_body, const Shape& other,
                   const Eigen::Isometry3d& base_from_other) const;
  Eigen::Vector3d imageOf(const Eigen::Vector3d& point) const { return flip_.cwiseProduct(point); }
  Eigen::Matrix3d imageOfTensor(const Eigen::Matrix3d& tensor) const {
    return flip_.asDiagonal() * tensor * flip_.asDiagonal();
  }

  Eigen::Vector3d flip_;
};

}  // namespace hexapod
