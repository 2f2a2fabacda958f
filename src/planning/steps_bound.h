#pragma once

#include <array>
#include <vector>

#include "planning/move.h"

namespace hexapod {

/// Bounds a set of points of the plane from outside: how far it extends in each direction.
class Extent {
 public:
  static constexpr int kDirections = 64;

  /// Of a set of which `extent(x, y)` tells how far it reaches in the unit direction (x, y).
  template <typename Function>
  static Extent of(Function&& extent);

  /// In any unit direction, never too little: that of the polygon which the kDirections leave.
  double towards(double x, double y) const;

  static double cosine(int direction);
  static double sine(int direction);

 private:
  std::array<double, kDirections> extents_{};
};

/// No chain of entries can reach a goal in fewer behaviours: proved from the repertoire alone.
///
/// One behaviour leads no farther than the longest. Where four or more are needed, the first two
/// end within the extent of all pairs as seen from the start, the last two begin within that of all
/// pairs as seen back from the goal, and those between bridge the gap: so the headings at both ends
/// count, and a goal behind a robot that only walks forward is farther than its distance.
class StepsBound {
 public:
  explicit StepsBound(const std::vector<Move>& moves);

  /// Behaviours at least, 1 or more; to within the tolerance.
  int operator()(const Pose2& start_from_goal, const GoalTolerance& tolerance) const;

  /// Longest distance that one behaviour covers, as the crow flies and along its path [m].
  double longest_m() const { return longest_m_; }
  double longest_path_m() const { return longest_path_m_; }

 private:
  double gap_m(const Pose2& start_from_goal, const GoalTolerance& tolerance) const;

  double longest_m_ = 0.0;
  double longest_path_m_ = 0.0;
  Extent pair_ends_;    ///< where pairs end, in the frame of their start
  Extent pair_starts_;  ///< where pairs start, in the frame of their end
};

}  // namespace hexapod
