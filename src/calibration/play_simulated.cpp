#include "calibration/play_simulated.h"

#include "simulation/rollout.h"

namespace hexapod {
namespace {

Pose2 measured(const World& world, const PoseNoise& noise, Random& random) {
  Pose2 pose = footprint(world.worldFromBase());
  pose.x_m += noise.position_m * random.normal();
  pose.y_m += noise.position_m * random.normal();
  pose.yaw_rad = wrapAngle(pose.yaw_rad + noise.heading_rad * random.normal());
  return pose;
}

}  // namespace

std::vector<Trial> playSimulated(World& world, const BehaviorOptions& behavior,
                                 const std::vector<Trial>& planned, const PoseNoise& noise,
                                 Random& random) {
  std::vector<Trial> played;
  world.restart();
  for (Trial trial : planned) {
    trial.seen.world_from_before = measured(world, noise, random);
    const Outcome outcome = play(world, Behavior(world.robot(), trial.seen.genome, behavior),
                                 behavior.command_period_s);
    if (outcome.verdict == Verdict::kFell || outcome.verdict == Verdict::kDiverged) {
      world.restart();
      continue;
    }
    trial.seen.world_from_after = measured(world, noise, random);
    played.push_back(trial);
  }
  return played;
}

}  // namespace hexapod
