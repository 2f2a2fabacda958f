#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>

#include "geometry/pose2.h"

namespace hexapod {

/// Names a cell of the plane.
using Cell = std::pair<std::int64_t, std::int64_t>;

/// The cell that an end position belongs to; headings play no part.
using Cells = std::function<Cell(const Pose2& end)>;

/// Squares of `cell_m` x `cell_m` [m], one of them centred on the origin. Throws
/// std::invalid_argument unless cell_m is finite and above 0.
Cells gridCells(double cell_m);

/// The cells of a centroidal Voronoi tessellation (Vassiliades et al. 2018): `count` centroids
/// spread by k-means over the disk of `radius_m` [m] around the origin; a position belongs to the
/// centroid nearest to it, beyond the disk as well. The same cells in every run. Throws
/// std::invalid_argument unless count is 1 or more and radius_m finite and above 0.
Cells voronoiCells(std::size_t count, double radius_m);

}  // namespace hexapod
