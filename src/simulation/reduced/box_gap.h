#pragma once

#include <initializer_list>

#include "simulation/reduced/model.h"

namespace hexapod::reduced {

/// A capsule of a leg in the world: its centre and the direction of its centre line.
template <typename Real>
struct PlacedCapsule {
  Vec3<Real> center, axis;
};

/// A box of a leg in the world.
template <typename Real>
struct PlacedBox {
  Vec3<Real> center;
  Rotation<Real> axes;
};

template <typename Real>
inline Real clamped(const Real& x, double bound) {
  return smaller<Real>(larger<Real>(x, splat<Real>(-bound)), splat<Real>(bound));
}

/// The points `center + t axis` in the axes of a box.
template <typename Real>
struct LineInBox {
  Real at[3], along[3];

  Real excess(int i, const Real& t, const double (&half)[3]) const {
    const Real place = at[i] + t * along[i];
    return place - clamped<Real>(place, half[i]);
  }
  Real squaredDistance(const Real& t, const double (&half)[3]) const {
    const Real x = excess(0, t, half), y = excess(1, t, half), z = excess(2, t, half);
    return x * x + y * y + z * z;
  }
  /// Half the derivative of squaredDistance(): it never falls, and bends only where the line leaves
  /// the space between two opposite sides.
  Real slope(const Real& t, const double (&half)[3]) const {
    return along[0] * excess(0, t, half) + along[1] * excess(1, t, half) +
           along[2] * excess(2, t, half);
  }
};

template <typename Real>
inline LineInBox<Real> lineInBox(const PlacedCapsule<Real>& line, const PlacedBox<Real>& box) {
  const Vec3<Real> apart = line.center - box.center;
  const Rotation<Real>& axes = box.axes;
  return {{dot(axes.x, apart), dot(axes.y, apart), dot(axes.z, apart)},
          {dot(axes.x, line.axis), dot(axes.y, line.axis), dot(axes.z, line.axis)}};
}

/// Square of the smallest distance of a segment and a box [m^2]; 0 where they meet. Exact: the
/// slope is taken at every bend, which leaves a stretch on which it is straight.
template <typename Real>
inline Real squaredDistanceToBox(const PlacedCapsule<Real>& capsule, double half_length,
                                 const PlacedBox<Real>& box, const double (&half_size)[3]) {
  constexpr double kAcross = 1e-12;
  const LineInBox<Real> line = lineInBox<Real>(capsule, box);
  Real low = splat<Real>(-half_length), high = splat<Real>(half_length);
  for (int i = 0; i < 3; ++i) {
    // Along a side there is no bend, nor is there one beyond the ends.
    const Mask<Real> across = magnitude(line.along[i]) > kAcross;
    const Real along = select<Real>(across, line.along[i], splat<Real>(1.0));
    for (const double side : {-half_size[i], half_size[i]}) {
      const Real bend = select<Real>(across, (side - line.at[i]) / along, low);
      const Real within = smaller<Real>(larger<Real>(bend, low), high);
      const Mask<Real> falls = line.slope(within, half_size) <= 0.0;
      low = select<Real>(falls, within, low);
      high = select<Real>(falls, high, within);
    }
  }
  const Real at_low = line.slope(low, half_size), at_high = line.slope(high, half_size);
  const Real rise = at_high - at_low;
  const Mask<Real> rises = rise > 0.0;
  const Real share =
      select<Real>(rises, -at_low / select<Real>(rises, rise, splat<Real>(1.0)), Real());
  const Real bounded = smaller<Real>(larger<Real>(share, Real()), splat<Real>(1.0));
  return line.squaredDistance(low + bounded * (high - low), half_size);
}

/// How far two boxes are apart along that one of fifteen directions - normals of sides, and what is
/// perpendicular to an edge of each - along which they are farthest apart [m]: not more than their
/// distance, and above 0 if and only if they do not meet (separating axes).
template <typename Real>
inline Real gapOfBoxes(const PlacedBox<Real>& a, const double (&half_a)[3],
                       const PlacedBox<Real>& b, const double (&half_b)[3]) {
  // Edges parallel to about a thousandth of a degree say nothing that sides do not.
  constexpr double kParallel = 1e-10;
  const Vec3<Real> apart = b.center - a.center;
  const Vec3<Real>* const of_a[3] = {&a.axes.x, &a.axes.y, &a.axes.z};
  const Vec3<Real>* const of_b[3] = {&b.axes.x, &b.axes.y, &b.axes.z};
  Real cosine[3][3], size[3][3], shift[3];
  for (int i = 0; i < 3; ++i) {
    shift[i] = dot(*of_a[i], apart);
    for (int j = 0; j < 3; ++j) {
      cosine[i][j] = dot(*of_a[i], *of_b[j]);
      size[i][j] = magnitude(cosine[i][j]);
    }
  }
  Real gap = splat<Real>(-1e3);
  for (int i = 0; i < 3; ++i) {
    const Real of_b_along =
        half_b[0] * size[i][0] + half_b[1] * size[i][1] + half_b[2] * size[i][2];
    gap = larger<Real>(gap, magnitude(shift[i]) - (half_a[i] + of_b_along));
    const Real of_a_along =
        half_a[0] * size[0][i] + half_a[1] * size[1][i] + half_a[2] * size[2][i];
    gap = larger<Real>(gap, magnitude(dot(*of_b[i], apart)) - (half_b[i] + of_a_along));
  }
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      const Real squared = 1.0 - cosine[i][j] * cosine[i][j];
      const Mask<Real> crossing = squared > kParallel;
      const Real between = magnitude(shift[i2] * cosine[i1][j] - shift[i1] * cosine[i2][j]);
      const Real halves = half_a[i1] * size[i2][j] + half_a[i2] * size[i1][j] +
                          half_b[j1] * size[i][j2] + half_b[j2] * size[i][j1];
      const Real length = squareRoot(select<Real>(crossing, squared, splat<Real>(1.0)));
      const Real along = select<Real>(crossing, (between - halves) / length, gap);
      gap = larger<Real>(gap, along);
    }
  }
  return gap;
}

}  // namespace hexapod::reduced
