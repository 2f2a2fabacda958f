#pragma once

#include <cstddef>
#include <vector>

#include "common/random.h"
#include "evolution/target.h"
#include "geometry/pose2.h"

namespace hexapod {

/// Spreads `count` targets over the points by K-means: k-means++ seeding (Arthur & Vassilvitskii
/// 2007), then Lloyd's iterations until no point changes its target. Headings play no part. Throws
/// std::invalid_argument when count is 0 or larger than the number of points.
std::vector<Target> kMeans(const std::vector<Pose2>& points, std::size_t count, Random random);

/// Median distance [m] of the points from their nearest targets: the smallest sparseness that
/// controllers ending exactly on the targets can have (Cully & Mouret 2013, figure 5, left). 0
/// without points or targets.
double sparsenessOf(const std::vector<Pose2>& points, const std::vector<Target>& targets);

}  // namespace hexapod
