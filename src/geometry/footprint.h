#pragma once

#include <Eigen/Core>
#include <vector>

namespace hexapod {

/// A disc of the floor, in the frame of base_footprint.
struct Disc {
  double x_m = 0.0;
  double y_m = 0.0;
  double radius_m = 0.0;
};

/// The floor that a robot may cover while it stands at a pose, whatever its legs do there: a union
/// of discs. Empty: a point.
struct Footprint {
  std::vector<Disc> discs;

  /// Radius of the largest disc around base_footprint itself that is sure to be covered; 0 or less
  /// when there is none [m].
  double inner_m() const;
  /// Distance from base_footprint to the farthest centre of a disc [m].
  double offset_m() const;
  /// Distance from base_footprint to the rim [m].
  double outer_m() const;
  /// Every disc larger by `margin_m`.
  Footprint grownBy(double margin_m) const;
};

/// Convex hull of points, counter-clockwise, without its collinear points.
std::vector<Eigen::Vector2d> convexHull(std::vector<Eigen::Vector2d> points);

/// Discs side by side along the longer side of the points that cover their convex hull: one where
/// that is about as long as wide, up to five of a long robot.
Footprint coverWithDiscs(const std::vector<Eigen::Vector2d>& points);

}  // namespace hexapod
