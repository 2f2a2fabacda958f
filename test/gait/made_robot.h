#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

#include "common/random.h"
#include "gait/genome.h"
#include "robot/robot_description.h"

namespace hexapod {

/// A robot without bodies: `legs` legs of `segments` joints that move pi/8 at signal 1 (the first
/// joint) and +-pi/4 at signal 2 (the others) about 0.1 rad, as fast as 6.28 rad/s.
inline RobotDescription madeRobot(int legs, int segments) {
  RobotDescription robot;
  robot.name = "made";
  for (int i = 0; i < legs; ++i) {
    Leg leg;
    for (int j = 0; j < segments; ++j) {
      Joint joint;
      joint.name = "joint_" + std::to_string(i) + "_" + std::to_string(j);
      joint.lower_rad = -M_PI / 2;
      joint.upper_rad = M_PI / 2;
      joint.max_torque_nm = 1.5;
      joint.max_velocity_rad_per_s = 6.28;
      joint.neutral_rad = 0.1;
      joint.signal = j == 0 ? Signal::kFirst : Signal::kSecond;
      joint.amplitude_rad = j == 0 ? M_PI / 8 : (j % 2 == 1 ? M_PI / 4 : -M_PI / 4);
      leg.segments.push_back({joint, Body()});
    }
    robot.legs.push_back(leg);
  }
  return robot;
}

/// What a call complains about, "" when it does not throw std::invalid_argument.
template <typename Call>
std::string complaintOf(const Call& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

}  // namespace hexapod
