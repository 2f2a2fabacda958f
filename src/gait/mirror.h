#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "gait/symmetry.h"
#include "robot/robot_description.h"

namespace hexapod {

/// A reflection of space, or a half turn about z, applied to a robot in its neutral pose: looks
/// whether the image is the robot again. See symmetriesOf().
class Mirror {
 public:
  /// The robot must outlive it.
  Mirror(const RobotDescription& robot, double x_sign, double y_sign);

  /// The image of each leg, or nothing when the image is another robot.
  std::optional<std::vector<Symmetry::LegImage>> legImages();

  /// After legImages() gave nothing: what has no image, with the first difference found.
  const std::string& difference() const { return difference_; }

 private:
  /// A leg's image if `other` is that, or how far along the leg they agree and what differs then.
  struct Comparison {
    std::optional<Symmetry::LegImage> image;
    std::size_t agreeing_parts = 0;
    double apart_m = 0.0;  ///< image of the hip from the other leg's
    std::string difference;
  };

  Comparison compare(const Leg& leg, const Leg& other) const;
  std::string jointDifference(const Joint& joint, const Joint& other, double sense) const;
  std::string bodyDifference(const Body& body, const Eigen::Isometry3d& base_from_body,
                             const Body& other, const Eigen::Isometry3d& base_from_other) const;
  bool shapesMatch(const Shape& shape, const Eigen::Isometry3d& base_from_body, const Shape& other,
                   const Eigen::Isometry3d& base_from_other) const;
  Eigen::Vector3d imageOf(const Eigen::Vector3d& point) const { return flip_.cwiseProduct(point); }
  Eigen::Matrix3d imageOfTensor(const Eigen::Matrix3d& tensor) const {
    return flip_.asDiagonal() * tensor * flip_.asDiagonal();
  }

  const RobotDescription& robot_;
  Eigen::Vector3d flip_;
  double length_tolerance_m_;
  std::string difference_;
};

}  // namespace hexapod
