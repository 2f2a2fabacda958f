#pragma once

#include "simulation/reduced/algebra.h"

namespace hexapod::reduced {

/// atan2(y, x) for y >= 0, x >= 0, not both 0, to about one unit in the last place; the same bits
/// in every lane of every width, which the C library does not promise.
template <typename Real>
inline Real arcTangent(const Real& y, const Real& x) {
  // atan(y/x) = q pi/4 + atan((y cos - x sin) / (x cos + y sin)) with q 0, 1 or 2: |argument| <=
  // tan(pi/8).
  constexpr double kTanPi8 = 0.41421356237309503;
  const auto high = x < kTanPi8 * y;
  const auto low = y <= kTanPi8 * x;
  const Real above = select<Real>(high, -x, select<Real>(low, y, y - x));
  const Real below = select<Real>(high, y, select<Real>(low, x, x + y));
  const Real offset = select<Real>(high, splat<Real>(1.5707963267948966),
                                   select<Real>(low, Real(), splat<Real>(0.7853981633974483)));
  const Real t = above / below;
  const Real u = t * t;
  // Least-squares Chebyshev fit of (atan(t)/t - 1)/t^2 in t^2 on [0, tan(pi/8)^2].
  Real series = splat<Real>(-0.019176887119062259);
  series = series * u + 0.0392316582955871913;
  series = series * u - 0.0508544973794025986;
  series = series * u + 0.0585814891280220988;
  series = series * u - 0.06664511447381948;
  series = series * u + 0.0769218319082608656;
  series = series * u - 0.0909090457812390189;
  series = series * u + 0.111111110152563617;
  series = series * u - 0.142857142846665429;
  series = series * u + 0.199999999999955207;
  series = series * u - 0.333333333333333302;
  return offset + (t + t * u * series);
}

/// Angle [rad] of the child about the hinge's axis, as ODE reads it from the rotation between the
/// two bodies: twice the angle of the whole quaternion, so gaps off the axis count too.
/// `child_from_parent` is the rotation at angle 0, `axis` the hinge's in the child.
template <typename Real>
inline Real hingeAngle(const Quaternion<Real>& child, const Quaternion<Real>& parent,
                       const Quaternion<double>& child_from_parent, const Vec3<double>& axis) {
  const Quaternion<Real> turned = (conjugate(child) * parent) * conjugate(child_from_parent);
  const Vec3<Real> v{turned.x, turned.y, turned.z};
  const Real half = arcTangent<Real>(squareRoot(dot(v, v)), magnitude(turned.w));
  const Real along = dot(v, axis);
  // `turned` goes from the child back to where it would be at angle 0.
  const Real flip = select<Real>(along >= 0.0, splat<Real>(-2.0), splat<Real>(2.0));
  return half * select<Real>(turned.w >= 0.0, flip, -flip);
}

}  // namespace hexapod::reduced
