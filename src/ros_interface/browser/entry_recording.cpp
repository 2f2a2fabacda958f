#include "ros_interface/browser/entry_recording.h"

#include "gait/behavior.h"

namespace hexapod {

Recording recordEntry(const RobotDescription& robot, const LearnedWorld& learned,
                      const Genome& genome) {
  const auto world = makeWorld(chooseEngine("reduced", robot).engine, robot, learned.physics);
  const Behavior behavior(robot, genome, learned.behavior);
  return record(*world, behavior, learned.behavior.command_period_s);
}

}  // namespace hexapod
