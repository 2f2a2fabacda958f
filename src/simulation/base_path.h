#pragma once

#include <vector>

#include "gait/behavior.h"
#include "gait/genome.h"
#include "simulation/world_pool.h"

namespace hexapod {

/// Where base_footprint is while each genome's behaviour is played from the settled stand, in the
/// frame of the start: every `period_s` or a bit more often, and at the end. Empty where it fails.
std::vector<std::vector<Pose2>> basePaths(WorldPool& worlds, const BehaviorOptions& options,
                                          const std::vector<Genome>& genomes,
                                          double period_s = 0.1);

}  // namespace hexapod
