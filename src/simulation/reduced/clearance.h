#pragma once

#include "simulation/reduced/tree.h"

namespace hexapod::reduced {

/// A capsule of a leg in the world: center line and half length.
template <typename Real>
struct PlacedCapsule {
  Vec3<Real> center, axis;
};

template <typename Real>
inline Real clamped(const Real& x, double bound) {
  return smaller<Real>(larger<Real>(x, splat<Real>(-bound)), splat<Real>(bound));
}

/// Square of the smallest distance of two segments [m^2]; parallel ones included.
template <typename Real>
inline Real squaredDistance(const PlacedCapsule<Real>& a, double half_a,
                            const PlacedCapsule<Real>& b, double half_b) {
  const Vec3<Real> apart = a.center - b.center;
  const Real cosine = dot(a.axis, b.axis);
  const Real along_a = dot(a.axis, apart), along_b = dot(b.axis, apart);
  const Real parallel = larger<Real>(1.0 - cosine * cosine, splat<Real>(1e-12));
  Real on_a = clamped<Real>((cosine * along_b - along_a) / parallel, half_a);
  const Real on_b = clamped<Real>(cosine * on_a + along_b, half_b);
  on_a = clamped<Real>(cosine * on_b - along_a, half_a);
  const Vec3<Real> between = apart + on_a * a.axis - on_b * b.axis;
  return dot(between, between);
}

/// ODE's rule for capsules parallel to about 0.2 degrees that lie side by side: it looks at the
/// middle of the stretch they share only. Changes `squared` in those lanes.
template <typename Real>
inline void applyParallelRule(const PlacedCapsule<Real>& a, double half_a,
                              const PlacedCapsule<Real>& b, double half_b, Real& squared) {
  constexpr double kParallel = 1e-5;
  const Real cosine = dot(a.axis, b.axis);
  const Mask<Real> parallel = 1.0 - cosine * cosine < kParallel;
  if (!any<Real>(parallel)) return;
  const Vec3<Real> apart = a.center - b.center;
  const Real shift = dot(a.axis, apart);
  const Real low = larger<Real>(splat<Real>(-half_a), -half_b - shift);
  const Real high = smaller<Real>(splat<Real>(half_a), half_b - shift);
  const Real middle = 0.5 * (low + high);
  const Real sign = select<Real>(cosine < 0.0, splat<Real>(-1.0), splat<Real>(1.0));
  const Vec3<Real> between = apart + middle * a.axis - Real(sign * (middle + shift)) * b.axis;
  squared = select<Real>(parallel & (low <= high), dot(between, between), squared);
}

/// Watches whether two legs touch, with ODE's verdict at every step but few of its tests.
///
/// Each pair of legs keeps its clearance since it was last looked at; every step takes off what the
/// legs can have moved relative to the base since. Only pairs whose clearance may be used up are
/// looked at again.
template <typename Real>
class LegClearance {
 public:
  /// Nothing is known of any lane, or of one.
  void forget() {
    for (auto& row : clearance_) {
      for (Real& clearance : row) clearance = Real();
    }
  }
  void forget(int lane) {
    for (auto& row : clearance_) {
      for (Real& clearance : row) setLane(clearance, lane, 0.0);
    }
  }

  /// Lanes in which two legs touch at the poses of `state` and `tree`.
  template <int kSegments>
  Mask<Real> touching(const ReducedModel& model, const State<Real>& state,
                      const TreeTerms<Real, kSegments>& tree) {
    Mask<Real> touch = noLanes<Real>();
    placed_ = 0;
    for (int a = 0; a < model.legs; ++a) {
      for (int b = a + 1; b < model.legs; ++b) {
        if (!any<Real>(clearance_[a][b] <= 0.0)) continue;
        place(model, state, tree, a);
        place(model, state, tree, b);
        clearance_[a][b] = clearance(model, a, b);
        touch = touch | (clearance_[a][b] <= 0.0);
      }
    }
    return touch;
  }

  /// Takes off what one step moves: `travel` [m] bounds the way of any point of a leg.
  void use(const ReducedModel& model, const Real (&travel)[kMaxLegs]) {
    for (int a = 0; a < model.legs; ++a) {
      for (int b = a + 1; b < model.legs; ++b) {
        clearance_[a][b] = clearance_[a][b] - (travel[a] + travel[b]);
      }
    }
  }

 private:
  template <int kSegments>
  void place(const ReducedModel& model, const State<Real>& state,
             const TreeTerms<Real, kSegments>& tree, int leg) {
    if (placed_ & (1u << leg)) return;
    placed_ |= 1u << leg;
    for (int i = model.first_capsule[leg]; i < model.first_capsule[leg + 1]; ++i) {
      const LegCapsule& capsule = model.capsule[i];
      const Rotation<Real>& axes = tree.leg[leg].placement[capsule.segment].world_from_body;
      capsules_[i] = {state.segment[leg][capsule.segment].position + axes * capsule.center,
                      axes * capsule.axis};
    }
  }

  Real clearance(const ReducedModel& model, int leg_a, int leg_b) const {
    Real smallest = splat<Real>(1e3);
    for (int a = model.first_capsule[leg_a]; a < model.first_capsule[leg_a + 1]; ++a) {
      for (int b = model.first_capsule[leg_b]; b < model.first_capsule[leg_b + 1]; ++b) {
        const LegCapsule &first = model.capsule[a], &second = model.capsule[b];
        Real squared = squaredDistance<Real>(capsules_[a], first.half_length, capsules_[b],
                                             second.half_length);
        applyParallelRule<Real>(capsules_[a], first.half_length, capsules_[b], second.half_length,
                                squared);
        const Real gap = squareRoot(squared) - (first.radius + second.radius);
        smallest = smaller<Real>(smallest, gap);
      }
    }
    return smallest;
  }

  Real clearance_[kMaxLegs][kMaxLegs];
  PlacedCapsule<Real> capsules_[kMaxCapsules];
  unsigned placed_;
};

}  // namespace hexapod::reduced
