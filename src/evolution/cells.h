#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>

#include "geometry/pose_metric.h"

namespace hexapod {

/// Names a cell of the plane or, where headings count, of the space of poses.
using Cell = std::array<std::int64_t, 3>;

/// The cell that an end belongs to.
using Cells = std::function<Cell(const Pose2& end)>;

/// Squares of `cell_m` x `cell_m` [m], one of them centred on the origin. Where headings count,
/// each is cut into equal parts of a turn, which are about as far apart by the metric, one of them
/// centred on 0. Throws std::invalid_argument unless cell_m is finite and above 0.
Cells gridCells(double cell_m, const PoseMetric& metric = {});

/// The cells of a centroidal Voronoi tessellation (Vassiliades et al. 2018): `count` centroids
/// spread by k-means over the disk of `radius_m` [m] around the origin; a position belongs to the
/// centroid nearest to it, beyond the disk as well, whatever the heading. The same cells in every
/// run. Throws std::invalid_argument unless count is 1 or more and radius_m finite and above 0.
Cells voronoiCells(std::size_t count, double radius_m);

}  // namespace hexapod
