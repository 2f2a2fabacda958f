#pragma once

#include <string>
#include <vector>

#include "gait/behavior_options.h"
#include "robot/robot_description.h"

namespace hexapod {

/// How a robot stands in its neutral pose, a second after it was put on the floor.
struct StandingCheck {
  std::string failure;    ///< a sentence when it does not stand; all else is then of no meaning
  double height_m = 0.0;  ///< of the base's origin
  double tilt_rad = 0.0;
  double sag_rad = 0.0;               ///< largest difference of a joint from its neutral angle
  double torque_share = 0.0;          ///< of the most loaded joint's torque, standing on all legs
  std::vector<std::string> on_floor;  ///< links that touch the floor
};

/// What becomes of random gaits, each played from the stand.
struct RandomGaitsCheck {
  int gaits = 0;
  int fell = 0, self_collided = 0, diverged = 0;
  double median_way_m = 0.0;  ///< of those that walked
  double largest_way_m = 0.0;
  double median_shift_m = 0.0;     ///< of ends, between steps of 15 and 5 ms, where both walked
  double back_to_neutral_s = 0.0;  ///< after the gait, in nine of ten
  double evaluations_per_s = 0.0;  ///< on one core of this machine
  std::string engine;              ///< that simulated them
  std::string engine_remark;       ///< why not the fast one, or ""

  int walked() const { return gaits - fell - self_collided - diverged; }
};

StandingCheck checkStanding(const RobotDescription& robot);

/// Plays `gaits` gaits drawn with a fixed seed. Throws std::runtime_error when the robot does not
/// stand.
RandomGaitsCheck checkRandomGaits(const RobotDescription& robot, int gaits);

/// Where the foot goes from its neutral place for a signal at -1 and at 1: "(-5.9 +0.0 +0.0) ..
/// (+5.9 +0.0 +0.0)", cm forward, left and up.
std::string footWay(const Leg& leg, Signal signal);

/// The same for one joint of the leg, moved alone by its signal.
std::string footWay(const Leg& leg, std::size_t joint);

/// That of both signals, in a line.
std::string footWay(const Leg& leg);

}  // namespace hexapod
