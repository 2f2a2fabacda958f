#include "simulation/physics.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "common/text.h"
#include "robot/robot_scales.h"

namespace hexapod {
namespace {

void checkRange(const char* name, double value, double min, double max) {
  if (value >= min && value <= max) return;
  throw std::invalid_argument("Physics value " + std::string(name) + " must be between " +
                              numberText(min) + " and " + numberText(max) + ", found " +
                              numberText(value) + ".");
}

// What gears and friction of a servo without power resist with, as a share of its torque.
constexpr double kLimpTorqueShare = 0.0133;
// A missing leg keeps enough mass for the equations to stay well conditioned.
constexpr double kMissingMassShare = 1e-3;

void checkCount(const RobotDescription& robot, const char* what, std::size_t found,
                std::size_t expected) {
  if (found == 0 || found == expected) return;
  throw std::invalid_argument("Physics of robot '" + robot.name + "' must have " +
                              std::to_string(expected) + " " + what + ", or none; found " +
                              std::to_string(found) + ".");
}

void checkBody(const RobotDescription& robot, const Physics& physics) {
  checkCount(robot, "leg states", physics.legs.size(), robot.legs.size());
  checkCount(robot, "joint torque scales", physics.joint_torque_scales.size(), robot.jointCount());
  for (std::size_t leg = 0; leg < physics.legs.size(); ++leg) {
    checkCount(robot, ("locked angles of leg '" + robot.legs[leg].name + "'").c_str(),
               physics.legs[leg].locked_rad.size(), robot.legs[leg].segments.size());
  }
}

void damage(Leg& leg, LegCondition condition) {
  for (Segment& segment : leg.segments) {
    if (condition == LegCondition::kLimp) {
      // A motor that wants no velocity brakes with its torque: friction.
      segment.joint.max_torque_nm *= kLimpTorqueShare;
      segment.joint.max_velocity_rad_per_s = 0.0;
    } else if (condition == LegCondition::kMissing) {
      scaleMass(kMissingMassShare, segment.body);
      segment.body.shapes.clear();
    }
  }
}

}  // namespace

void checkPhysics(const Physics& physics) {
  checkRange("step_s", physics.step_s, 1e-4, 0.1);
  checkRange("gravity_m_per_s2", physics.gravity_m_per_s2, 0.0, 100.0);
  checkRange("friction_scale", physics.friction_scale, 0.0, 100.0);
  checkRange("mass_scale", physics.mass_scale, 0.01, 100.0);
  checkRange("servo_gain_scale", physics.servo_gain_scale, 0.0, 100.0);
  checkRange("torque_scale", physics.torque_scale, 0.0, 100.0);
  checkRange("slope_x_rad", physics.slope_x_rad, -1.0, 1.0);
  checkRange("slope_y_rad", physics.slope_y_rad, -1.0, 1.0);
  checkRange("command_latency_s", physics.command_latency_s, 0.0, 1.0);
  for (const double scale : physics.joint_torque_scales) {
    checkRange("joint_torque_scales", scale, 0.0, 100.0);
  }
}

RobotDescription underPhysics(const RobotDescription& robot, const Physics& physics) {
  checkBody(robot, physics);
  RobotDescription scaled = robot;
  applyScales(
      {physics.friction_scale, physics.servo_gain_scale, physics.torque_scale, physics.mass_scale},
      scaled);
  std::size_t joint = 0;
  for (std::size_t i = 0; i < scaled.legs.size(); ++i) {
    for (Segment& segment : scaled.legs[i].segments) {
      if (!physics.joint_torque_scales.empty()) {
        segment.joint.max_torque_nm *= physics.joint_torque_scales[joint];
      }
      ++joint;
    }
    if (!physics.legs.empty()) damage(scaled.legs[i], physics.legs[i].condition);
  }
  return scaled;
}

bool touchCounts(const Physics& physics, std::size_t leg) {
  return physics.legs.empty() || physics.legs[leg].isDriven();
}

std::size_t latencySteps(const Physics& physics) {
  return static_cast<std::size_t>(std::llround(physics.command_latency_s / physics.step_s));
}

HeldJoints::HeldJoints(const RobotDescription& robot, const Physics& physics) {
  checkBody(robot, physics);
  std::size_t first = 0;
  for (std::size_t leg = 0; leg < physics.legs.size(); ++leg) {
    const std::vector<double> angles_rad = heldAngles(robot, leg, physics.legs[leg]);
    for (std::size_t s = 0; s < angles_rad.size(); ++s) held_.push_back({first + s, angles_rad[s]});
    first += robot.legs[leg].segments.size();
  }
}

void HeldJoints::apply(std::vector<double>& targets_rad) const {
  for (const Held& held : held_) targets_rad[held.joint] = held.angle_rad;
}

Eigen::Vector3d gravityOnFloor(const Physics& physics) {
  const Eigen::Vector3d down(-std::tan(physics.slope_x_rad), -std::tan(physics.slope_y_rad), -1.0);
  return physics.gravity_m_per_s2 / down.norm() * down;
}

bool isAbsurd(const Eigen::Vector3d& position_m, const Eigen::Vector3d& velocity_m_per_s,
              const Eigen::Vector3d& rate_rad_per_s) {
  // Comparisons with NaN are false.
  return !position_m.allFinite() || !(velocity_m_per_s.norm() <= kAbsurdSpeed_m_per_s) ||
         !(rate_rad_per_s.norm() <= kAbsurdRate_rad_per_s);
}

}  // namespace hexapod
