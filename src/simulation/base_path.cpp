#include "simulation/base_path.h"

#include <algorithm>
#include <cmath>

#include "simulation/recording.h"

namespace hexapod {
namespace {

std::vector<Pose2> basePath(World& world, const Behavior& behavior, double command_period_s,
                            std::size_t commands_between) {
  const Recording recording = record(world, behavior, command_period_s);
  const Pose2 start_from_world = inverse(recording.world_from_start);
  const std::size_t count = behavior.commandCount();
  std::vector<Pose2> path;
  if (recording.poses.size() < count) return path;
  for (std::size_t k = 0; k < count; ++k) {
    if ((k + 1) % commands_between == 0 || k + 1 == count) {
      path.push_back(start_from_world * footprint(recording.poses[k].world_from_base));
    }
  }
  return path;
}

}  // namespace

std::vector<std::vector<Pose2>> basePaths(WorldPool& worlds, const BehaviorOptions& options,
                                          const std::vector<Genome>& genomes, double period_s) {
  const auto between =
      static_cast<std::size_t>(std::max(1.0, std::floor(period_s / options.command_period_s)));
  std::vector<std::vector<Pose2>> paths(genomes.size());
  worlds.forEach(genomes.size(), [&](World& world, std::size_t i) {
    const Behavior behavior(world.robot(), genomes[i], options);
    paths[i] = basePath(world, behavior, options.command_period_s, between);
  });
  return paths;
}

}  // namespace hexapod
