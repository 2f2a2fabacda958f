#include "robot_import/fit_shape.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "simulation/reduced/box_gap.h"

namespace hexapod {
namespace {

constexpr double kThinnest_m = 0.001;

struct Bounds {
  Eigen::Matrix3d axes;  // columns, in the frame of the points
  Eigen::Vector3d low, high;

  Eigen::Vector3d size() const { return (high - low).cwiseMax(kThinnest_m); }
  Eigen::Vector3d center() const { return axes * (0.5 * (low + high)); }
};

Bounds boundsAlong(const Points& points, const Eigen::Matrix3d& axes) {
  Bounds bounds{axes, axes.transpose() * points.front(), axes.transpose() * points.front()};
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3d along = axes.transpose() * point;
    bounds.low = bounds.low.cwiseMin(along);
    bounds.high = bounds.high.cwiseMax(along);
  }
  return bounds;
}

Eigen::Matrix3d principalAxes(const Points& points) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) mean += point / static_cast<double>(points.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& point : points) {
    covariance += (point - mean) * (point - mean).transpose();
  }
  Eigen::Matrix3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors();
  if (axes.determinant() < 0.0) axes.col(0) *= -1.0;
  return axes;
}

Bounds smallestBounds(const Points& points) {
  // The frame's own axes unless the others save something: vertices crowd where details are.
  constexpr double kSaving = 0.8;
  const Bounds own = boundsAlong(points, principalAxes(points));
  const Bounds given = boundsAlong(points, Eigen::Matrix3d::Identity());
  return own.size().prod() < kSaving * given.size().prod() ? own : given;
}

Shape roundShape(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius_m) {
  Shape shape;
  shape.kind = Shape::Kind::kCapsule;
  shape.radius_m = radius_m;
  shape.length_m = (b - a).norm();
  shape.body_from_shape.translation() = 0.5 * (a + b);
  if (shape.length_m < kThinnest_m) {
    shape.kind = Shape::Kind::kSphere;
    shape.length_m = 0.0;
    return shape;
  }
  shape.body_from_shape.linear() =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), b - a).toRotationMatrix();
  return shape;
}

// Smallest distance of two segments, of any length: the nearest points by alternating projection,
// which is exact after the clamping of Ericson, Real-Time Collision Detection, 5.1.9.
double segmentDistance(const Points& a, const Points& b) {
  const Eigen::Vector3d u = a.back() - a.front();
  const Eigen::Vector3d v = b.back() - b.front();
  const Eigen::Vector3d w = a.front() - b.front();
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v);
  const auto within = [](double share) { return std::clamp(share, 0.0, 1.0); };
  const double parallel = uu * vv - uv * uv;
  double s = parallel > 1e-18 ? within((uv * v.dot(w) - vv * u.dot(w)) / parallel) : 0.0;
  double t = vv > 0.0 ? within((uv * s + v.dot(w)) / vv) : 0.0;
  s = uu > 0.0 ? within((uv * t - u.dot(w)) / uu) : 0.0;
  return (w + s * u - t * v).norm();
}

reduced::Vec3<double> vec3(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

// A box as the reduced engine sees it.
struct PlacedBox {
  explicit PlacedBox(const Shape& box)
      : half_m{0.5 * box.size_m.x(), 0.5 * box.size_m.y(), 0.5 * box.size_m.z()} {
    const Eigen::Matrix3d axes = box.body_from_shape.linear();
    placed = {vec3(box.body_from_shape.translation()),
              {vec3(axes.col(0)), vec3(axes.col(1)), vec3(axes.col(2))}};
  }

  double half_m[3];
  reduced::PlacedBox<double> placed;
};

double gapToBox_m(const Shape& round, const Shape& box) {
  const PlacedBox of_box(box);
  const reduced::PlacedCapsule<double> capsule{vec3(round.body_from_shape.translation()),
                                               vec3(round.body_from_shape.linear().col(2))};
  const double half_m = round.kind == Shape::Kind::kCapsule ? 0.5 * round.length_m : 0.0;
  return std::sqrt(
             reduced::squaredDistanceToBox<double>(capsule, half_m, of_box.placed, of_box.half_m)) -
         round.radius_m;
}

double distanceFrom(const Eigen::Vector3d& point, const Shape& shape) {
  if (shape.kind == Shape::Kind::kBox) {
    const Eigen::Vector3d local = shape.body_from_shape.inverse() * point;
    return (local.cwiseAbs() - 0.5 * shape.size_m).maxCoeff();
  }
  return segmentDistance({point}, corePoints(shape)) - shape.radius_m;
}

}  // namespace

Points corePoints(const Shape& shape) {
  Points points;
  if (shape.kind == Shape::Kind::kBox) {
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
      points.push_back(shape.body_from_shape * (0.5 * shape.size_m.cwiseProduct(sign)));
    }
    return points;
  }
  const Eigen::Vector3d half = 0.5 * shape.length_m * Eigen::Vector3d::UnitZ();
  points.push_back(shape.body_from_shape * half);
  if (shape.kind == Shape::Kind::kCapsule) points.push_back(shape.body_from_shape * -half);
  return points;
}

double roundness_m(const Shape& shape) {
  return shape.kind == Shape::Kind::kBox ? 0.0 : shape.radius_m;
}

Shape fitBox(const Points& points) {
  const Bounds bounds = smallestBounds(points);
  Shape shape;
  shape.kind = Shape::Kind::kBox;
  shape.size_m = bounds.size();
  shape.body_from_shape.linear() = bounds.axes;
  shape.body_from_shape.translation() = bounds.center();
  return shape;
}

Shape fitCapsule(const Points& points) {
  const Bounds bounds = smallestBounds(points);
  const Eigen::Vector3d size = bounds.size();
  int longest = 0;
  size.maxCoeff(&longest);
  const double across_m = std::sqrt(size.prod() / size[longest]);
  const double radius_m = 0.5 * std::min(across_m, size[longest]);
  const Eigen::Vector3d half = (0.5 * size[longest] - radius_m) * bounds.axes.col(longest);
  return roundShape(bounds.center() - half, bounds.center() + half, radius_m);
}

Shape fitTip(const Points& points, const Eigen::Vector3d& root) {
  // 1. The tip: the middle of the points within a tenth of the farthest distance.
  constexpr double kTipShare = 0.9;
  double farthest_m = 0.0;
  for (const Eigen::Vector3d& p : points) farthest_m = std::max(farthest_m, (p - root).norm());
  if (farthest_m < kThinnest_m) return fitCapsule(points);
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();
  double count = 0.0;
  for (const Eigen::Vector3d& p : points) {
    if ((p - root).norm() < kTipShare * farthest_m) continue;
    tip += p;
    count += 1.0;
  }
  const Eigen::Vector3d axis = (tip / count - root).normalized();
  // 2. As thick as the points in the outer half of the link are at the median.
  std::vector<double> off_axis_m;
  double length_m = 0.0;
  for (const Eigen::Vector3d& p : points) {
    const double along_m = axis.dot(p - root);
    length_m = std::max(length_m, along_m);
    if (along_m > 0.5 * farthest_m) off_axis_m.push_back((p - root - along_m * axis).norm());
  }
  const auto middle = off_axis_m.begin() + static_cast<std::ptrdiff_t>(off_axis_m.size() / 2);
  std::nth_element(off_axis_m.begin(), middle, off_axis_m.end());
  const double radius_m = std::clamp(*middle, 0.5 * kThinnest_m, 0.15 * length_m);
  return roundShape(root + std::min(radius_m, 0.5 * length_m) * axis,
                    root + (length_m - radius_m) * axis, radius_m);
}

Shape rod(const Eigen::Vector3d& end, double radius_m) {
  const Eigen::Vector3d axis = end.normalized();
  return roundShape(radius_m * axis, end - radius_m * axis, radius_m);
}

bool isInside(const Shape& inner, const Shape& outer) {
  for (const Eigen::Vector3d& point : corePoints(inner)) {
    if (distanceFrom(point, outer) + roundness_m(inner) > kThinnest_m) return false;
  }
  return true;
}

double gap_m(const Shape& a, const Shape& b) {
  if (a.kind == Shape::Kind::kBox && b.kind == Shape::Kind::kBox) {
    const PlacedBox first(a), second(b);
    return reduced::gapOfBoxes<double>(first.placed, first.half_m, second.placed, second.half_m);
  }
  if (b.kind == Shape::Kind::kBox) return gapToBox_m(a, b);
  if (a.kind == Shape::Kind::kBox) return gapToBox_m(b, a);
  return segmentDistance(corePoints(a), corePoints(b)) - a.radius_m - b.radius_m;
}

Shape thinner(const Shape& shape, double factor) {
  Shape made = shape;
  made.radius_m *= factor;
  int longest = 0;
  const double length_m = shape.size_m.maxCoeff(&longest);
  made.size_m *= factor;
  made.size_m[longest] = length_m;
  return made;
}

double thickness_m(const Shape& shape) {
  return shape.kind == Shape::Kind::kBox ? shape.size_m.minCoeff() : 2.0 * shape.radius_m;
}

double volume_m3(const Shape& shape) {
  if (shape.kind == Shape::Kind::kBox) return shape.size_m.prod();
  const double r = shape.radius_m;
  return M_PI * r * r * (shape.length_m + 4.0 / 3.0 * r);
}

Eigen::Matrix3d solidInertia(const Shape& shape) {
  Eigen::Vector3d moments;
  if (shape.kind == Shape::Kind::kBox) {
    const Eigen::Vector3d squares = shape.size_m.cwiseProduct(shape.size_m);
    moments = shape.size_m.prod() / 12.0 *
              Eigen::Vector3d(squares.y() + squares.z(), squares.x() + squares.z(),
                              squares.x() + squares.y());
  } else {
    const double r = shape.radius_m, h = shape.length_m;
    const double cylinder = M_PI * r * r * h, caps = 4.0 / 3.0 * M_PI * r * r * r;
    const double along = cylinder * r * r / 2.0 + caps * 2.0 * r * r / 5.0;
    const double across = cylinder * (h * h / 12.0 + r * r / 4.0) +
                          caps * (2.0 * r * r / 5.0 + h * h / 4.0 + 3.0 * h * r / 8.0);
    moments = Eigen::Vector3d(across, across, along);
  }
  const Eigen::Matrix3d axes = shape.body_from_shape.linear();
  return axes * moments.asDiagonal() * axes.transpose();
}

}  // namespace hexapod
