#pragma once

#include <cmath>

namespace hexapod::reduced {

/// `kCount` doubles that are added, multiplied and compared element by element: GCC's vector
/// extension, one SIMD register where the target has one of that size.
template <int kCount>
struct LanesOf {
  typedef double type __attribute__((vector_size(8 * kCount)));
};
template <int kCount>
using Lanes = typename LanesOf<kCount>::type;

/// What the engine computes with: `double` for one robot, Lanes<n> for n robots at once. Every
/// function below is exact or correctly rounded element by element, nothing is contracted or
/// reordered, so that a robot gets the same bits in whichever lane of whichever width it runs.
template <typename Real>
constexpr int kLanesIn = sizeof(Real) / sizeof(double);

/// What a comparison of two Reals gives: bool, or one all-ones or all-zeros word per lane.
template <typename Real>
using Mask = decltype(Real() < Real());

template <typename Real>
inline Real splat(double value) {
  return Real() + value;
}

template <typename Real>
inline Mask<Real> noLanes() {
  return Real() < Real();
}

template <typename Real>
inline Mask<Real> allLanes() {
  return Real() <= Real();
}

template <typename Real>
inline Real select(const Mask<Real>& mask, const Real& yes, const Real& no) {
  return mask ? yes : no;
}

template <typename Real>
inline Mask<Real> notMask(const Mask<Real>& mask) {
  if constexpr (kLanesIn<Real> == 1) {
    return !mask;
  } else {
    return ~mask;
  }
}

template <typename Real>
inline bool inLane(const Mask<Real>& mask, int lane) {
  if constexpr (kLanesIn<Real> == 1) {
    return mask;
  } else {
    return mask[lane] != 0;
  }
}

/// True when the mask holds in any lane.
template <typename Real>
inline bool any(const Mask<Real>& mask) {
  if constexpr (kLanesIn<Real> == 1) {
    return mask;
  } else {
    auto sum = mask[0];
    for (int i = 1; i < kLanesIn<Real>; ++i) sum |= mask[i];
    return sum != 0;
  }
}

inline double lane(double value, int) { return value; }
template <typename Real>
inline double lane(const Real& value, int index) {
  return value[index];
}

inline void setLane(double& value, int, double to) { value = to; }
template <typename Real>
inline void setLane(Real& value, int index, double to) {
  value[index] = to;
}

inline double squareRoot(double x) { return std::sqrt(x); }
template <typename Real>
inline Real squareRoot(const Real& x) {
  Real root;
  for (int i = 0; i < kLanesIn<Real>; ++i) root[i] = __builtin_sqrt(x[i]);
  return root;
}

template <typename Real>
inline Real magnitude(const Real& x) {
  return select<Real>(x < 0.0, -x, x);
}

template <typename Real>
inline Real smaller(const Real& a, const Real& b) {
  return select<Real>(a < b, a, b);
}

template <typename Real>
inline Real larger(const Real& a, const Real& b) {
  return select<Real>(a > b, a, b);
}

}  // namespace hexapod::reduced
