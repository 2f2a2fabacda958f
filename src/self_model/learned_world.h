#pragma once

#include "gait/behavior_options.h"
#include "repertoire/repertoire.h"
#include "simulation/world.h"

namespace hexapod {

/// How the entries of a repertoire are played, and the physics they were learned in.
struct LearnedWorld {
  BehaviorOptions behavior;
  Physics physics;
};

/// From the options that the repertoire keeps, the body it was learned for among them; defaults for
/// those it does not. Throws std::invalid_argument when one is out of range, or is about another
/// robot.
LearnedWorld learnedWorldOf(const RobotDescription& robot, const Repertoire& repertoire);

}  // namespace hexapod
