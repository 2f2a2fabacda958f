#include "simulation/recording.h"

#include <cstddef>
#include <utility>

#include "simulation/rollout.h"

namespace hexapod {

Recording record(World& world, const Behavior& behavior, double command_period_s) {
  const std::size_t steps = stepsPerCommand(command_period_s, world.physics().step_s);
  world.restart();
  Recording recording;
  recording.world_from_start = footprint(world.worldFromBase());
  recording.poses.reserve(behavior.commandCount());
  for (std::size_t k = 0; k < behavior.commandCount(); ++k) {
    world.setTargets(behavior.command(k));
    for (std::size_t i = 0; i < steps; ++i) {
      if (world.step() != Verdict::kWalked) return recording;
    }
    RecordedPose pose;
    pose.world_from_base = world.worldFromBase();
    world.jointAngles(pose.angles_rad);
    recording.poses.push_back(std::move(pose));
  }
  return recording;
}

}  // namespace hexapod
