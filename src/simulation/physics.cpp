#include "simulation/physics.h"

#include <cmath>
#include <locale>
#include <sstream>
#include <stdexcept>

namespace hexapod {
namespace {

void checkRange(const char* name, double value, double min, double max) {
  if (value >= min && value <= max) return;
  std::ostringstream sentence;
  sentence.imbue(std::locale::classic());
  sentence << "Physics value " << name << " must be between " << min << " and " << max << ", found "
           << value << ".";
  throw std::invalid_argument(sentence.str());
}

void scaleBody(Body& body, const Physics& physics) {
  body.mass_kg *= physics.mass_scale;
  body.inertia_kg_m2 *= physics.mass_scale;
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
}

RobotDescription underPhysics(const RobotDescription& robot, const Physics& physics) {
  RobotDescription scaled = robot;
  scaled.contact.friction *= physics.friction_scale;
  scaled.servo.gain_per_s *= physics.servo_gain_scale;
  scaleBody(scaled.base, physics);
  for (Leg& leg : scaled.legs) {
    for (Segment& segment : leg.segments) {
      scaleBody(segment.body, physics);
      segment.joint.max_torque_nm *= physics.torque_scale;
    }
  }
  return scaled;
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
