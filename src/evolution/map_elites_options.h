#pragma once

#include <cstdint>
#include <vector>

#include "common/options.h"

namespace hexapod {

/// How MAP-Elites cuts the plane into cells (see gridCells() and voronoiCells()).
struct MapElitesOptions {
  double cell_m = 0.05;           ///< map_elites: side of the square cells [m]
  std::int64_t cvt_cells = 1000;  ///< cvt_map_elites: centroids
  double cvt_radius_m = 0.8;      ///< cvt_map_elites: of the disk they are spread over [m]
};

/// The options with name, unit, range and meaning, bound to `options`.
std::vector<Option> declareOptions(MapElitesOptions& options);

}  // namespace hexapod
