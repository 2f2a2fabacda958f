#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "repertoire/entry.h"

namespace hexapod {

/// What a metric looks at: where a controller ends and how well aligned.
struct Ending {
  Pose2 pose;  ///< in the start frame
  double orientation_error_rad = 0.0;
};

/// Of every entry, as learned.
std::vector<Ending> learnedEndings(const std::vector<Entry>& entries);

/// Of every usable entry, as a planner should expect it: the executed mean where there is one, its
/// orientation error measured against the arc through that mean.
std::vector<Ending> expectedEndings(const std::vector<Entry>& entries);

/// The region of interest of Cully & Mouret 2013, figure 2C: positions within 60 degrees of the
/// longitudinal axis, in front and in the rear, on arcs shorter than 0.6 m. 0.669 m^2.
struct RegionOfInterest {
  double half_angle_rad =
      1.0471975511965976;     ///< polar angle off the x axis, either way; inclusive
  double arc_length_m = 0.6;  ///< exclusive
  double grid_step_m = 0.01;  ///< > 0

  /// The same region for a robot of other size.
  RegionOfInterest scaledBy(double length_scale) const;

  /// The origin belongs to it.
  bool contains(double x_m, double y_m) const;

  /// The points (i, j) * grid_step_m inside, by rows of y and then by x; headings are 0.
  std::vector<Pose2> grid() const;
};

/// Distances [m] from each position to the nearest ending, in order. Empty without endings.
std::vector<double> distancesToNearest(const std::vector<Pose2>& positions,
                                       const std::vector<Ending>& endings);

/// The middle value, or the mean of the two middle ones. Empty without values.
std::optional<double> median(std::vector<double> values);

/// Figures of a repertoire. Those that have no meaning without endings are 0 then: look at the
/// counts first.
struct RepertoireMetrics {
  std::size_t endings = 0;
  std::size_t endings_in_region = 0;
  /// Median distance of the region's grid points from the nearest ending, inside or outside of the
  /// region [m] (figure 4, top).
  double sparseness_m = 0.0;
  /// Median orientation error over the endings in the region [rad]. The paper's figure 4 says "over
  /// all the controllers inside the reachable area", its section 4.1 makes the region the part of
  /// that area that is looked at; results are stated with this one.
  double median_error_in_region_rad = 0.0;
  double median_error_of_all_rad = 0.0;    ///< over all endings, wherever they are [rad]
  double density_in_region_per_dm2 = 0.0;  ///< endings in the region per square decimetre
  double max_reach_m = 0.0;                ///< largest distance of an ending from the start
};

RepertoireMetrics measure(const std::vector<Ending>& endings, const RegionOfInterest& region = {});

}  // namespace hexapod
