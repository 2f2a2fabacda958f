#include "robot/robot_scales.h"

namespace hexapod {

void scaleMass(double scale, Body& body) {
  body.mass_kg *= scale;
  body.inertia_kg_m2 *= scale;
}

void applyScales(const RobotScales& scales, RobotDescription& robot) {
  robot.contact.friction *= scales.friction;
  robot.servo.gain_per_s *= scales.servo_gain;
  scaleMass(scales.mass, robot.base);
  for (Leg& leg : robot.legs) {
    for (Segment& segment : leg.segments) {
      scaleMass(scales.mass, segment.body);
      segment.joint.max_torque_nm *= scales.torque;
    }
  }
}

}  // namespace hexapod
