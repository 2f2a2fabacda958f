#include "robot/dimensions.h"

#include <algorithm>
#include <cmath>

namespace hexapod {
namespace {

// Of config/hexapod.yaml and its URDF.
constexpr double kMass_kg = 3.06;
constexpr double kReach_m = 0.29;
constexpr double kSlip_per_n_s = 0.02;
constexpr double kSoftCfm = 0.001;
// Its largest height is 0.5 m.
constexpr double kHeightPerReach = 0.5 / kReach_m;

// Farthest point of a shape from the origin of its body.
double extent_m(const Shape& shape) {
  // In the shape's own axes: the corner on the far side, or the cap on it.
  const Eigen::Isometry3d& pose = shape.body_from_shape;
  const Eigen::Vector3d center = (pose.linear().transpose() * pose.translation()).cwiseAbs();
  if (shape.kind == Shape::Kind::kBox) return (center + 0.5 * shape.size_m).norm();
  const Eigen::Vector3d cap = 0.5 * shape.length_m * Eigen::Vector3d::UnitZ();
  return (center + cap).norm() + shape.radius_m;
}

}  // namespace

bool isAbsurdInertia(const Body& body) {
  constexpr double kRoom = 1.5;
  if (body.shapes.empty() || !(body.mass_kg > 0.0)) return false;
  double farthest_m = 0.0;
  for (Shape shape : body.shapes) {
    shape.body_from_shape.pretranslate(-body.center_of_mass_m);
    farthest_m = std::max(farthest_m, extent_m(shape));
  }
  const double gyration_m2 = body.inertia_kg_m2.diagonal().maxCoeff() / body.mass_kg;
  return gyration_m2 > std::pow(kRoom * farthest_m, 2);
}

double totalMass_kg(const RobotDescription& robot) {
  double mass_kg = robot.base.mass_kg;
  for (const Leg& leg : robot.legs) {
    for (const Segment& segment : leg.segments) mass_kg += segment.body.mass_kg;
  }
  return mass_kg;
}

double reach_m(const Leg& leg) {
  double beyond_m = 0.0;
  for (auto segment = leg.segments.rbegin(); segment != leg.segments.rend(); ++segment) {
    double own_m = 0.0;
    for (const Shape& shape : segment->body.shapes) own_m = std::max(own_m, extent_m(shape));
    beyond_m = std::max(own_m, beyond_m);
    if (std::next(segment) == leg.segments.rend()) break;
    beyond_m += segment->joint.parent_from_joint.translation().norm();
  }
  return beyond_m;
}

double legReach_m(const RobotDescription& robot) {
  double sum_m = 0.0;
  for (const Leg& leg : robot.legs) sum_m += reach_m(leg);
  return robot.legs.empty() ? 0.0 : sum_m / static_cast<double>(robot.legs.size());
}

double lengthScale(const RobotDescription& robot) {
  return std::max(0.01, std::round(100.0 * legReach_m(robot) / kReach_m) / 100.0);
}

double slipFor(const RobotDescription& robot) {
  return kSlip_per_n_s * kMass_kg / totalMass_kg(robot);
}

double softCfmFor(const RobotDescription& robot) {
  return kSoftCfm * kMass_kg / totalMass_kg(robot);
}

double maxBaseHeightFor(const RobotDescription& robot) {
  double hip_m = 0.0;
  for (const Leg& leg : robot.legs) {
    if (leg.segments.empty()) continue;
    hip_m = std::max(hip_m, std::abs(leg.segments[0].joint.parent_from_joint.translation().z()));
  }
  return kHeightPerReach * legReach_m(robot) + hip_m;
}

}  // namespace hexapod
