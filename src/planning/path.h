#pragma once

#include <vector>

#include "geometry/pose2.h"

namespace hexapod {

/// Poses along one behaviour, from `world_from_start` (left out) to its end (included), at most
/// `spacing_m` (> 0) apart along the arc through the end position and at most 10 degrees apart in
/// heading. The heading follows the arc's tangent; what the end heading differs from it is added
/// evenly. A behaviour that ends more than 60 degrees off its arc (a sidestep) is drawn as a
/// straight line with evenly changing heading.
std::vector<Pose2> sampleStep(const Pose2& world_from_start, const Pose2& start_from_end,
                              double spacing_m);

/// The start pose, then sampleStep() of each successive pair of poses: a path to draw and to check.
std::vector<Pose2> samplePath(const Pose2& world_from_start,
                              const std::vector<Pose2>& world_from_ends, double spacing_m);

}  // namespace hexapod
