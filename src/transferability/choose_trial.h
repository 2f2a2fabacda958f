#pragma once

#include <cstddef>
#include <vector>

#include "repertoire/entry.h"
#include "repertoire/robot_trial.h"
#include "transferability/behavior_features.h"

namespace hexapod {

/// Index of the entry to try on the robot next: the one that ends farthest from all that were tried
/// and their images, and from standing still (Koos, Mouret & Doncieux 2013: diversity decides). A
/// radian counts as the length of the scales; of equally far ones the first. There must be entries.
std::size_t farthestFromTried(const std::vector<Entry>& entries,
                              const std::vector<RobotTrial>& trials, const FeatureScales& scales);

}  // namespace hexapod
