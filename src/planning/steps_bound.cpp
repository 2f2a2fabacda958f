#include "planning/steps_bound.h"

#include <algorithm>
#include <cmath>

#include "geometry/footprint.h"

namespace hexapod {
namespace {

/// Extent of all compositions of two of the given poses: over the first, its own position and the
/// hull of all as turned by it.
Extent extentOfPairs(const std::vector<Pose2>& poses) {
  std::vector<Eigen::Vector2d> positions;
  for (const Pose2& pose : poses) positions.emplace_back(pose.x_m, pose.y_m);
  const std::vector<Eigen::Vector2d> hull = convexHull(positions);
  const Extent single = Extent::of([&hull](double x, double y) {
    double extent = 0.0;
    for (const Eigen::Vector2d& point : hull)
      extent = std::max(extent, x * point.x() + y * point.y());
    return extent;
  });
  std::vector<Eigen::Vector2d> turns;
  for (const Pose2& pose : poses)
    turns.emplace_back(std::cos(pose.yaw_rad), std::sin(pose.yaw_rad));
  return Extent::of([&](double x, double y) {
    double extent = 0.0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const double c = turns[i].x();
      const double s = turns[i].y();
      const double beyond = single.towards(c * x + s * y, c * y - s * x);
      extent = std::max(extent, x * poses[i].x_m + y * poses[i].y_m + beyond);
    }
    return extent;
  });
}

double pathLength(const Move& move) {
  double length_m = 0.0;
  double bulge_m = 0.0;
  for (std::size_t i = 1; i < move.path.points.size(); ++i) {
    const MovePath::Point& a = move.path.points[i - 1];
    const MovePath::Point& b = move.path.points[i];
    length_m += std::hypot(b.x_m - a.x_m, b.y_m - a.y_m);
    bulge_m = std::max(bulge_m, b.bulge_m);
  }
  return std::max(length_m + 2.0 * bulge_m, move.length_m);
}

}  // namespace

template <typename Function>
Extent Extent::of(Function&& extent) {
  Extent result;
  for (int i = 0; i < kDirections; ++i) {
    result.extents_[static_cast<std::size_t>(i)] = extent(cosine(i), sine(i));
  }
  return result;
}

double Extent::cosine(int direction) { return std::cos(2.0 * M_PI / kDirections * direction); }

double Extent::sine(int direction) { return std::sin(2.0 * M_PI / kDirections * direction); }

// A direction between two is a combination of them, a u + b v with a, b >= 0, and what is within
// both half-planes extends no farther than a times the one and b times the other.
double Extent::towards(double x, double y) const {
  constexpr double kStep_rad = 2.0 * M_PI / kDirections;
  const double turn = std::atan2(y, x) / kStep_rad + kDirections;
  const double below = std::floor(turn);
  const double angle_rad = (turn - below) * kStep_rad;
  const auto first = static_cast<std::size_t>(below) % kDirections;
  static const double kSine = std::sin(kStep_rad);
  const double b = std::sin(angle_rad) / kSine;
  const double a = std::sin(kStep_rad - angle_rad) / kSine;
  return a * extents_[first] + b * extents_[(first + 1) % kDirections];
}

StepsBound::StepsBound(const std::vector<Move>& moves) {
  std::vector<Pose2> forth;
  std::vector<Pose2> back;
  for (const Move& move : moves) {
    longest_m_ = std::max(longest_m_, move.length_m);
    longest_path_m_ = std::max(longest_path_m_, pathLength(move));
    forth.push_back(move.end);
    back.push_back(inverse(move.end));
  }
  pair_ends_ = extentOfPairs(forth);
  pair_starts_ = extentOfPairs(back);
}

/// Between where two behaviours from the start end at best and where the last two begin.
double StepsBound::gap_m(const Pose2& start_from_goal, const GoalTolerance& tolerance) const {
  const double c = std::cos(start_from_goal.yaw_rad);
  const double s = std::sin(start_from_goal.yaw_rad);
  const double swing_m = tolerance.anyHeading() ? 0.0 : tolerance.yaw_rad * 2.0 * longest_m_;
  double gap_m = 0.0;
  for (int i = 0; i < Extent::kDirections; ++i) {
    const double x = Extent::cosine(i);
    const double y = Extent::sine(i);
    // From the goal back, in its own frame.
    const double back_m =
        tolerance.anyHeading()
            ? 2.0 * longest_m_
            : std::min(2.0 * longest_m_,
                       pair_starts_.towards(-(c * x + s * y), -(c * y - s * x)) + swing_m);
    gap_m = std::max(gap_m, x * start_from_goal.x_m + y * start_from_goal.y_m - back_m -
                                pair_ends_.towards(x, y));
  }
  return gap_m - tolerance.xy_m;
}

int StepsBound::operator()(const Pose2& start_from_goal, const GoalTolerance& tolerance) const {
  if (longest_m_ <= 0.0) return 1;
  // A hair less, so that rounding never proves too much.
  const auto steps = [this](double far_m) {
    return static_cast<int>(std::min(1e6, std::ceil((far_m - 1e-9) / longest_m_)));
  };
  const double far_m = std::hypot(start_from_goal.x_m, start_from_goal.y_m) - tolerance.xy_m;
  const int direct = std::max(1, steps(far_m));
  if (direct < 4) return direct;
  return std::max(direct, 4 + std::max(0, steps(gap_m(start_from_goal, tolerance))));
}

}  // namespace hexapod
