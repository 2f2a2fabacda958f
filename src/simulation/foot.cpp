#include "simulation/foot.h"

#include <algorithm>
#include <cstddef>

#include "simulation/kinematics.h"

namespace hexapod {
namespace {

// Of the height of the base.
constexpr double kStandingShare = 0.03;

Foot footOf(const Body& body, const Eigen::Isometry3d& world_from_body) {
  Foot foot{world_from_body.translation(), world_from_body.translation().z()};
  for (const Shape& shape : body.shapes) {
    const Eigen::Isometry3d world_from_shape = world_from_body * shape.body_from_shape;
    const double half_m =
        0.5 * (shape.kind == Shape::Kind::kBox ? shape.size_m.z() : shape.length_m);
    for (const double end : {-half_m, half_m}) {
      const Eigen::Vector3d place = world_from_shape * Eigen::Vector3d(0.0, 0.0, end);
      if (place.z() < foot.place.z()) foot.place = place;
    }
    foot.height_m = std::min(foot.height_m, lowestPoint(shape, world_from_shape));
  }
  return foot;
}

}  // namespace

std::vector<Foot> feetOf(const RobotDescription& robot, const RecordedPose& pose) {
  const std::vector<Eigen::Isometry3d> base_from_bodies = baseFromBodies(robot, pose.angles_rad);
  std::vector<Foot> feet;
  std::size_t body = 0;  // the base comes first
  for (const Leg& leg : robot.legs) {
    body += leg.segments.size();
    feet.push_back(footOf(leg.segments.back().body, pose.world_from_base * base_from_bodies[body]));
  }
  return feet;
}

double standingFootHeight(const RobotDescription& robot) {
  return kStandingShare * standingHeight(robot);
}

}  // namespace hexapod
