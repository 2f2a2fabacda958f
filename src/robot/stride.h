#pragma once

#include "robot/robot_description.h"

namespace hexapod {

/// How far the foot goes along the ground from its place in the neutral pose for a first signal of
/// 1 [m], by the derivatives there; within what the joints' velocities allow in a quarter of a
/// gait's period of 1 s.
double stride_m(const Leg& leg);

/// lengthScale(), and less for feet that step less far for their reach than those of the hexapod
/// that the learner's lengths are made for: what those are multiplied with.
double strideScale(const RobotDescription& robot);

}  // namespace hexapod
