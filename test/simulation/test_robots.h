#pragma once

#include "gait/behavior_options.h"
#include "gait/genome.h"
#include "robot/robot_description.h"
#include "simulation/world.h"

namespace hexapod {

/// Of commands, as in the paper.
constexpr double kPeriod_s = 0.030;

/// A hexapod written out by hand, so that these tests depend on no file: box body, six legs of
/// three capsules, joint axes up and sideways, tibia vertical in the neutral pose.
RobotDescription handMadeHexapod();

/// The same with hips that swing so far that neighbouring legs hit each other in a full tripod.
RobotDescription hexapodWithWideHips();

/// The same hexapod on legs of boxes, but for its hips and two of its feet.
RobotDescription hexapodOfBoxes();

/// Nothing moves.
Genome standing(const RobotDescription& robot);

/// The alternating tripod at full amplitude, from the robot's geometry: each leg swings forward in
/// the air while its neighbours push back on the floor.
Genome tripod(const RobotDescription& robot);

/// Genomes drawn uniformly, in canonical form.
std::vector<Genome> randomGenomes(const RobotDescription& robot, std::size_t count,
                                  std::uint64_t seed);

/// Where a body's velocity begins among its values of a WorldState.
constexpr std::size_t kVelocity = 7;

/// The state of a world whose robot was lifted, and rolled about the x axis of its base.
WorldState rolled(const RobotDescription& robot, WorldState state, double roll_rad, double lift_m);

/// A behaviour of 0.9 s, for tests in which the distance does not matter.
BehaviorOptions shortBehavior();

}  // namespace hexapod
