#pragma once

#include "simulation/reduced/real.h"

namespace hexapod::reduced {

/// Vectors, rotations and symmetric matrices over any Real (double or Lanes). Constants of the
/// robot are Vec3<double> and mix freely with Vec3<Real>.
template <typename Real>
struct Vec3 {
  Real x, y, z;
};

template <typename Real>
inline Vec3<Real> zeroVec3() {
  return {Real(), Real(), Real()};
}

template <typename A, typename B>
inline auto operator+(const Vec3<A>& a, const Vec3<B>& b) -> Vec3<decltype(A() + B())> {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <typename A, typename B>
inline auto operator-(const Vec3<A>& a, const Vec3<B>& b) -> Vec3<decltype(A() - B())> {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <typename A, typename B>
inline auto operator*(const A& a, const Vec3<B>& b) -> Vec3<decltype(A() * B())> {
  return {a * b.x, a * b.y, a * b.z};
}
template <typename A, typename B>
inline auto dot(const Vec3<A>& a, const Vec3<B>& b) -> decltype(A() * B()) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <typename A, typename B>
inline auto cross(const Vec3<A>& a, const Vec3<B>& b) -> Vec3<decltype(A() * B())> {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Unit quaternion w + xi + yj + zk: world_from_body.
template <typename Real>
struct Quaternion {
  Real w, x, y, z;
};

/// a * b.
template <typename A, typename B>
inline auto operator*(const Quaternion<A>& a, const Quaternion<B>& b)
    -> Quaternion<decltype(A() * B())> {
  return {
      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
      a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

template <typename Real>
inline Quaternion<Real> conjugate(const Quaternion<Real>& q) {
  return {q.w, -q.x, -q.y, -q.z};
}

/// Columns: the body's axes in the world.
template <typename Real>
struct Rotation {
  Vec3<Real> x, y, z;
};

template <typename Real>
inline Rotation<Real> rotationOf(const Quaternion<Real>& q) {
  const Real x2 = q.x + q.x, y2 = q.y + q.y, z2 = q.z + q.z;
  const Real xx = x2 * q.x, yy = y2 * q.y, zz = z2 * q.z;
  const Real xy = x2 * q.y, xz = x2 * q.z, yz = y2 * q.z;
  const Real wx = x2 * q.w, wy = y2 * q.w, wz = z2 * q.w;
  return {{1.0 - (yy + zz), xy + wz, xz - wy},
          {xy - wz, 1.0 - (xx + zz), yz + wx},
          {xz + wy, yz - wx, 1.0 - (xx + yy)}};
}

/// World coordinates of a vector that is constant in the body.
template <typename Real>
inline Vec3<Real> operator*(const Rotation<Real>& r, const Vec3<double>& v) {
  return {r.x.x * v.x + r.y.x * v.y + r.z.x * v.z, r.x.y * v.x + r.y.y * v.y + r.z.y * v.z,
          r.x.z * v.x + r.y.z * v.y + r.z.z * v.z};
}

/// Symmetric 3x3 matrix.
template <typename Real>
struct Sym3 {
  Real xx, yy, zz, xy, xz, yz;
};

template <typename Real>
inline Sym3<Real> operator+(const Sym3<Real>& a, const Sym3<Real>& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.xz + b.xz, a.yz + b.yz};
}
template <typename Real>
inline Vec3<Real> operator*(const Sym3<Real>& m, const Vec3<Real>& v) {
  return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
          m.xz * v.x + m.yz * v.y + m.zz * v.z};
}

/// scale * v v^T.
template <typename Real>
inline Sym3<Real> outerSquare(const Real& scale, const Vec3<Real>& v) {
  const Vec3<Real> s = scale * v;
  return {s.x * v.x, s.y * v.y, s.z * v.z, s.x * v.y, s.x * v.z, s.y * v.z};
}

/// mass (|v|^2 1 - v v^T): what moving the reference point by v adds to an inertia.
template <typename Real>
inline Sym3<Real> steiner(const Real& mass, const Vec3<Real>& v) {
  const Vec3<Real> s = mass * v;
  const Real xx = s.x * v.x, yy = s.y * v.y, zz = s.z * v.z;
  return {yy + zz, xx + zz, xx + yy, -(s.x * v.y), -(s.x * v.z), -(s.y * v.z)};
}

/// Angular and linear part of a spatial vector (motion, force or momentum), linear at the origin O.
template <typename Real>
struct Spatial {
  Vec3<Real> angular, linear;
};

template <typename Real>
inline Spatial<Real> zeroSpatial() {
  return {zeroVec3<Real>(), zeroVec3<Real>()};
}
template <typename Real>
inline Spatial<Real> operator+(const Spatial<Real>& a, const Spatial<Real>& b) {
  return {a.angular + b.angular, a.linear + b.linear};
}
template <typename Real>
inline Spatial<Real> operator-(const Spatial<Real>& a, const Spatial<Real>& b) {
  return {a.angular - b.angular, a.linear - b.linear};
}
template <typename Real>
inline Spatial<Real> operator*(const Real& a, const Spatial<Real>& b) {
  return {a * b.angular, a * b.linear};
}
template <typename Real>
inline Real dot(const Spatial<Real>& a, const Spatial<Real>& b) {
  return dot(a.angular, b.angular) + dot(a.linear, b.linear);
}

/// Velocity at `arm` from O of a body that moves with `motion`.
template <typename Real>
inline Vec3<Real> velocityAt(const Spatial<Real>& motion, const Vec3<Real>& arm) {
  return motion.linear + cross(motion.angular, arm);
}

}  // namespace hexapod::reduced
