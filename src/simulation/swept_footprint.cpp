#include "simulation/swept_footprint.h"

#include <algorithm>
#include <cmath>

#include "geometry/pose2.h"
#include "simulation/kinematics.h"

namespace hexapod {
namespace {

constexpr double kSpacing_m = 0.015;
constexpr int kSignalSteps = 8;  // per unit
constexpr int kRimPoints = 24;

/// Points of the shape, each with a radius, whose discs cover its projection.
void addDiscs(const Shape& shape, const Eigen::Isometry3d& frame_from_shape,
              std::vector<Disc>& discs) {
  const auto addLine = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius) {
    const int count = std::max(1, static_cast<int>(std::ceil((to - from).norm() / kSpacing_m)));
    for (int i = 0; i <= count; ++i) {
      const Eigen::Vector3d at = frame_from_shape * (from + (to - from) * i / count);
      discs.push_back({at.x(), at.y(), radius});
    }
  };
  if (shape.kind != Shape::Kind::kBox) {
    const Eigen::Vector3d half(0.0, 0.0, 0.5 * shape.length_m);
    addLine(-half, half, shape.radius_m);
    return;
  }
  // The rim of a box's projection is made of edges.
  const Eigen::Vector3d half = 0.5 * shape.size_m;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int corner : {0, 1, 2, 3}) {
      Eigen::Vector3d from = half;
      from[(axis + 1) % 3] *= corner & 1 ? 1.0 : -1.0;
      from[(axis + 2) % 3] *= corner & 2 ? 1.0 : -1.0;
      Eigen::Vector3d to = from;
      from[axis] *= -1.0;
      addLine(from, to, 0.0);
    }
  }
}

/// The next of all combinations of steps of the signals of a leg; false after the last one. Beyond
/// the first two, whose joints turn and lift a leg, signals have their extremes and the middle.
bool goOn(std::vector<int>& steps) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    steps[i] += i < 2 ? 1 : kSignalSteps;
    if (steps[i] <= kSignalSteps) return true;
    steps[i] = -kSignalSteps;
  }
  return false;
}

/// Joint angles with the signals of every leg at the given steps.
std::vector<double> anglesAt(const RobotDescription& robot, const std::vector<int>& steps) {
  std::vector<double> angles_rad;
  for (const Joint* joint : robot.joints()) {
    const double signal = steps[static_cast<std::size_t>(joint->signal) - 1] / double{kSignalSteps};
    angles_rad.push_back(std::clamp(joint->neutral_rad + joint->amplitude_rad * signal,
                                    joint->lower_rad, joint->upper_rad));
  }
  return angles_rad;
}

}  // namespace

std::vector<Disc> coveredDiscs(const RobotDescription& robot,
                               const Eigen::Isometry3d& world_from_base,
                               const std::vector<double>& angles_rad) {
  const Pose2 foot = footprint(world_from_base);
  const Eigen::Isometry3d world_from_foot =
      Eigen::Translation3d(foot.x_m, foot.y_m, 0.0) *
      Eigen::AngleAxisd(foot.yaw_rad, Eigen::Vector3d::UnitZ());
  const Eigen::Isometry3d foot_from_base = world_from_foot.inverse() * world_from_base;
  const std::vector<Eigen::Isometry3d> base_from_bodies = baseFromBodies(robot, angles_rad);
  const std::vector<const Body*> all = bodies(robot);
  std::vector<Disc> discs;
  for (std::size_t b = 0; b < all.size(); ++b) {
    for (const Shape& shape : all[b]->shapes) {
      addDiscs(shape, foot_from_base * base_from_bodies[b] * shape.body_from_shape, discs);
    }
  }
  return discs;
}

Footprint sweptFootprint(const RobotDescription& robot) {
  std::vector<Eigen::Vector2d> rim;
  // The corners of a polygon around a disc.
  const double outside = 1.0 / std::cos(M_PI / kRimPoints);
  std::vector<int> steps(robot.signalsPerLeg(), -kSignalSteps);
  do {
    const std::vector<double> angles_rad = anglesAt(robot, steps);
    for (const Disc& disc : coveredDiscs(robot, Eigen::Isometry3d::Identity(), angles_rad)) {
      for (int i = 0; i < kRimPoints; ++i) {
        const double turn = 2.0 * M_PI * i / kRimPoints;
        rim.emplace_back(disc.x_m + outside * disc.radius_m * std::cos(turn),
                         disc.y_m + outside * disc.radius_m * std::sin(turn));
      }
    }
  } while (goOn(steps));
  return coverWithDiscs(rim);
}

}  // namespace hexapod
