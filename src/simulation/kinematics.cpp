#include "simulation/kinematics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace hexapod {

std::vector<Eigen::Isometry3d> baseFromBodies(const RobotDescription& robot,
                                              const std::vector<double>& angles_rad) {
  std::vector<Eigen::Isometry3d> poses{Eigen::Isometry3d::Identity()};
  for (const Leg& leg : robot.legs) {
    Eigen::Isometry3d parent = Eigen::Isometry3d::Identity();
    for (const Segment& segment : leg.segments) {
      const Joint& joint = segment.joint;
      parent = parent * joint.parent_from_joint *
               Eigen::AngleAxisd(angles_rad[poses.size() - 1], joint.axis);
      poses.push_back(parent);
    }
  }
  return poses;
}

std::vector<const Body*> bodies(const RobotDescription& robot) {
  std::vector<const Body*> bodies{&robot.base};
  for (const Leg& leg : robot.legs) {
    for (const Segment& segment : leg.segments) bodies.push_back(&segment.body);
  }
  return bodies;
}

double lowestPoint(const Shape& shape, const Eigen::Isometry3d& world_from_shape) {
  const Eigen::RowVector3d up = world_from_shape.linear().row(2).cwiseAbs();
  const double center_m = world_from_shape.translation().z();
  switch (shape.kind) {
    case Shape::Kind::kBox:
      return center_m - 0.5 * up.dot(shape.size_m);
    case Shape::Kind::kCapsule:
      return center_m - 0.5 * up.z() * shape.length_m - shape.radius_m;
    case Shape::Kind::kSphere:
      break;
  }
  return center_m - shape.radius_m;
}

double standingHeight(const RobotDescription& robot) {
  const std::vector<Eigen::Isometry3d> poses = baseFromBodies(robot, robot.neutralPose());
  const std::vector<const Body*> all = bodies(robot);
  double lowest_m = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < all.size(); ++b) {
    for (const Shape& shape : all[b]->shapes) {
      lowest_m = std::min(lowest_m, lowestPoint(shape, poses[b] * shape.body_from_shape));
    }
  }
  if (!std::isfinite(lowest_m)) {
    throw std::invalid_argument("Robot '" + robot.name +
                                "' cannot stand: none of its links has a collision shape; give its "
                                "URDF <collision> elements.");
  }
  return -lowest_m;
}

}  // namespace hexapod
