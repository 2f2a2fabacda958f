#include "evolution/map_elites_options.h"

namespace hexapod {

std::vector<Option> declareOptions(MapElitesOptions& options) {
  return {
      option("cell_m", options.cell_m, "m", "Side of the square cells of map_elites.", 0.001, 10.0),
      option("cvt_cells", options.cvt_cells,
             "Cells of cvt_map_elites: centroids that k-means spreads over a disk.", 1, 20000),
      option("cvt_radius_m", options.cvt_radius_m, "m",
             "Radius of that disk; what ends beyond it belongs to the cells at its rim.", 0.001,
             100.0)};
}

}  // namespace hexapod
