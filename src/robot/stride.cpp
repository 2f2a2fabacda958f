#include "robot/stride.h"

#include <algorithm>
#include <cmath>

#include "robot/dimensions.h"

namespace hexapod {
namespace {

constexpr double kQuarterPeriod_s = 0.25;
// Of the hexapod of the paper: 0.0569 m of 0.29 m. A robot that was imported has 0.19.
constexpr double kStridePerReach = 0.19;

// The corner or cap of a body's shapes that is farthest from its joint, in the body's frame.
Eigen::Vector3d tipOf(const Body& body) {
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();
  const auto look = [&](const Eigen::Vector3d& point) {
    if (point.norm() > tip.norm()) tip = point;
  };
  for (const Shape& shape : body.shapes) {
    const Eigen::Vector3d half = shape.kind == Shape::Kind::kBox
                                     ? Eigen::Vector3d(0.5 * shape.size_m)
                                     : Eigen::Vector3d(0.0, 0.0, 0.5 * shape.length_m);
    look(shape.body_from_shape * half);
    look(shape.body_from_shape * -half);
  }
  return tip;
}

struct Hinge {
  Eigen::Vector3d at_m, axis;
};

}  // namespace

double stride_m(const Leg& leg) {
  Eigen::Isometry3d base_from_body = Eigen::Isometry3d::Identity();
  Eigen::Vector3d foot_m = Eigen::Vector3d::Zero();
  std::vector<Hinge> hinges;
  for (const Segment& segment : leg.segments) {
    const Joint& joint = segment.joint;
    base_from_body = base_from_body * joint.parent_from_joint;
    hinges.push_back({base_from_body.translation(), base_from_body.linear() * joint.axis});
    base_from_body = base_from_body * Eigen::AngleAxisd(joint.neutral_rad, joint.axis);
    const Eigen::Vector3d tip = tipOf(segment.body);
    if (tip.norm() > 0.0 || segment.body.shapes.empty()) foot_m = base_from_body * tip;
  }
  Eigen::Vector3d way_m = Eigen::Vector3d::Zero();
  for (std::size_t j = 0; j < hinges.size(); ++j) {
    const Joint& joint = leg.segments[j].joint;
    if (joint.signal != Signal::kFirst) continue;
    const double most_rad = kQuarterPeriod_s * joint.max_velocity_rad_per_s;
    way_m += std::clamp(joint.amplitude_rad, -most_rad, most_rad) *
             hinges[j].axis.cross(foot_m - hinges[j].at_m);
  }
  return way_m.head<2>().norm();
}

double strideScale(const RobotDescription& robot) {
  double strides_m = 0.0;
  for (const Leg& leg : robot.legs) strides_m += stride_m(leg);
  const double full_m =
      kStridePerReach * legReach_m(robot) * static_cast<double>(robot.legs.size());
  const double share = full_m > 0.0 ? std::min(1.0, strides_m / full_m) : 1.0;
  return std::max(0.01, std::round(100.0 * share * lengthScale(robot)) / 100.0);
}

}  // namespace hexapod
