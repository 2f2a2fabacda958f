#pragma once

#include <vector>

#include "geometry/pose2.h"

namespace hexapod {

/// Where base_footprint is on its way along each entry of a repertoire, in the frame of the start:
/// poses from shortly after the start to the end. Empty: not known.
using EntryPaths = std::vector<std::vector<Pose2>>;

/// The way of base_footprint along one move.
struct MovePath {
  struct Point {
    double x_m;
    double y_m;
    double cosine;  ///< of the heading
    double sine;
    double moved_m;     ///< way of base_footprint since the start
    double turned_rad;  ///< turns since the start, both ways
    double bulge_m;     ///< the way may be so far beside this point
  };

  std::vector<Point> points;  ///< from the start (included) to the end (included)
};

/// The path of a move that ends at `start_from_end`. `way` is what an earlier execution of it did,
/// bent to that end; when it is empty, the arc of sampleStep() with a bulge between both ends.
MovePath makeMovePath(const Pose2& start_from_end, const std::vector<Pose2>& way);

}  // namespace hexapod
