#pragma once

#include "gait/genome.h"
#include "robot/robot_description.h"
#include "self_model/learned_world.h"
#include "simulation/recording.h"

namespace hexapod {

/// A genome's behaviour as it is learned, in the fast engine where that covers the robot.
Recording recordEntry(const RobotDescription& robot, const LearnedWorld& learned,
                      const Genome& genome);

}  // namespace hexapod
