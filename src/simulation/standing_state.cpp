#include "simulation/standing_state.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "common/text.h"
#include "geometry/pose2.h"
#include "simulation/kinematics.h"

namespace hexapod {
namespace {

std::array<double, 4> coefficients(const Eigen::Quaterniond& q) {
  return {q.w(), q.x(), q.y(), q.z()};
}

}  // namespace

WorldState standingState(const RobotDescription& robot) {
  const std::vector<double> neutral = robot.neutralPose();
  const std::vector<Eigen::Isometry3d> base_from_bodies = baseFromBodies(robot, neutral);
  const std::vector<const Body*> links = bodies(robot);
  const Eigen::Isometry3d world_from_base(Eigen::Translation3d(0.0, 0.0, standingHeight(robot)));
  WorldState state;
  for (std::size_t b = 0; b < links.size(); ++b) {
    const Eigen::Isometry3d world_from_body = world_from_base * base_from_bodies[b];
    const Eigen::Vector3d center = world_from_body * links[b]->center_of_mass_m;
    const auto q = coefficients(Eigen::Quaterniond(world_from_body.linear()));
    state.values.insert(state.values.end(), {center.x(), center.y(), center.z()});
    state.values.insert(state.values.end(), q.begin(), q.end());
    state.values.insert(state.values.end(), 6, 0.0);
  }
  state.values.insert(state.values.end(), neutral.begin(), neutral.end());
  return state;
}

Eigen::Isometry3d baseOf(const RobotDescription& robot, const WorldState& state) {
  const double* v = state.values.data();
  Eigen::Isometry3d world_from_base = Eigen::Isometry3d::Identity();
  world_from_base.linear() = Eigen::Quaterniond(v[3], v[4], v[5], v[6]).toRotationMatrix();
  world_from_base.translation() =
      Eigen::Vector3d(v) - world_from_base.linear() * robot.base.center_of_mass_m;
  return world_from_base;
}

WorldState footprintAtOrigin(const Eigen::Isometry3d& world_from_base, WorldState state,
                             std::size_t body_count, double heading_rad) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(heading_rad - footprint(world_from_base).yaw_rad,
                                                  Eigen::Vector3d::UnitZ()));
  const Eigen::Vector3d start(world_from_base.translation().x(), world_from_base.translation().y(),
                              0.0);
  for (std::size_t b = 0; b < body_count; ++b) {
    double* values = &state.values[b * kStateValuesPerBody];
    Eigen::Map<Eigen::Vector3d> position(values);
    const Eigen::Quaterniond q(values[3], values[4], values[5], values[6]);
    Eigen::Map<Eigen::Vector3d> velocity(values + 7);
    Eigen::Map<Eigen::Vector3d> rate(values + 10);
    const auto turned = coefficients((turn * q).normalized());
    position = (turn * (position - start)).eval();
    std::copy(turned.begin(), turned.end(), values + 3);
    velocity = (turn * velocity).eval();
    rate = (turn * rate).eval();
  }
  return state;
}

void throwDoesNotStand(const RobotDescription& robot, Verdict verdict, double time_s) {
  throw std::runtime_error("Robot '" + robot.name +
                           "' does not stand: put on the floor in its neutral pose, its simulation "
                           "is '" +
                           toString(verdict) + "' after " + numberText(time_s) +
                           " s; change its neutral pose, masses or torques, or the physics.");
}

}  // namespace hexapod
