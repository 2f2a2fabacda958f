#include "geometry/footprint.h"

#include <algorithm>
#include <cmath>

namespace hexapod {
namespace {

using Points = std::vector<Eigen::Vector2d>;

// A robot so much longer than wide is covered by one more disc.
constexpr double kLongEnough = 1.4;
constexpr int kMaxDiscs = 5;

double cross(const Eigen::Vector2d& o, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
}

/// The part of a convex polygon whose coordinate `axis` times `sign` is at most `limit`.
Points clipped(const Points& polygon, int axis, double sign, double limit) {
  Points result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    const double over_a = sign * a[axis] - limit;
    const double over_b = sign * b[axis] - limit;
    if (over_a <= 0.0) result.push_back(a);
    if ((over_a < 0.0) != (over_b < 0.0) && over_a != over_b) {
      result.push_back(a + (b - a) * (over_a / (over_a - over_b)));
    }
  }
  return result;
}

/// A disc around the middle of the points' bounding box.
Disc discAround(const Points& points) {
  Eigen::Vector2d low = points.front();
  Eigen::Vector2d high = points.front();
  for (const Eigen::Vector2d& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const Eigen::Vector2d middle = 0.5 * (low + high);
  double radius = 0.0;
  for (const Eigen::Vector2d& point : points) radius = std::max(radius, (point - middle).norm());
  return {middle.x(), middle.y(), radius};
}

}  // namespace

double Footprint::inner_m() const {
  double inner = 0.0;
  for (const Disc& disc : discs) {
    inner = std::max(inner, disc.radius_m - std::hypot(disc.x_m, disc.y_m));
  }
  return inner;
}

double Footprint::offset_m() const {
  double offset = 0.0;
  for (const Disc& disc : discs) offset = std::max(offset, std::hypot(disc.x_m, disc.y_m));
  return offset;
}

double Footprint::outer_m() const {
  double outer = 0.0;
  for (const Disc& disc : discs) {
    outer = std::max(outer, disc.radius_m + std::hypot(disc.x_m, disc.y_m));
  }
  return outer;
}

Footprint Footprint::grownBy(double margin_m) const {
  Footprint grown = *this;
  for (Disc& disc : grown.discs) disc.radius_m += margin_m;
  return grown;
}

// Andrew's monotone chain.
std::vector<Eigen::Vector2d> convexHull(std::vector<Eigen::Vector2d> points) {
  if (points.size() < 3) return points;
  std::sort(points.begin(), points.end(), [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  Points hull;
  const auto addChain = [&hull](auto first, auto last) {
    const std::size_t base = hull.size() + 1;
    for (; first != last; ++first) {
      while (hull.size() > base && cross(hull[hull.size() - 2], hull.back(), *first) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(*first);
    }
    hull.pop_back();  // begins the next chain
  };
  addChain(points.begin(), points.end());
  addChain(points.rbegin(), points.rend());
  if (hull.empty()) hull.push_back(points.front());
  return hull;
}

Footprint coverWithDiscs(const std::vector<Eigen::Vector2d>& points) {
  Footprint footprint;
  if (points.empty()) return footprint;
  const Points hull = convexHull(points);
  Eigen::Vector2d low = hull.front();
  Eigen::Vector2d high = hull.front();
  for (const Eigen::Vector2d& point : hull) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const Eigen::Vector2d size = high - low;
  const int axis = size.x() >= size.y() ? 0 : 1;
  const double ratio = size[axis] / std::max(size[1 - axis], 1e-6);
  const int count = std::clamp(static_cast<int>(std::ceil(ratio / kLongEnough)), 1, kMaxDiscs);
  for (int i = 0; i < count; ++i) {
    const double from = low[axis] + size[axis] * i / count;
    const double to = low[axis] + size[axis] * (i + 1) / count;
    const Points strip = clipped(clipped(hull, axis, -1.0, -from), axis, 1.0, to);
    if (!strip.empty()) footprint.discs.push_back(discAround(strip));
  }
  return footprint;
}

}  // namespace hexapod
