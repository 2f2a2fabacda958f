#pragma once

#include "simulation/reduced/box_gap.h"
#include "simulation/reduced/tree.h"

namespace hexapod::reduced {

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
    for (int i = model.first_shape[leg]; i < model.first_shape[leg + 1]; ++i) {
      const LegShape& shape = model.leg_shape[i];
      const Rotation<Real>& axes = tree.leg[leg].placement[shape.segment].world_from_body;
      capsules_[i] = {state.segment[leg][shape.segment].position + axes * shape.center,
                      axes * shape.axes.z};
      if (shape.is_box) {
        boxes_[i] = {capsules_[i].center,
                     {axes * shape.axes.x, axes * shape.axes.y, capsules_[i].axis}};
      }
    }
  }

  Real clearance(const ReducedModel& model, int leg_a, int leg_b) const {
    Real smallest = splat<Real>(1e3);
    for (int a = model.first_shape[leg_a]; a < model.first_shape[leg_a + 1]; ++a) {
      for (int b = model.first_shape[leg_b]; b < model.first_shape[leg_b + 1]; ++b) {
        smallest = smaller<Real>(smallest, gap(model, a, b));
      }
    }
    return smallest;
  }

  // Not more than the distance of two shapes, and above 0 if and only if they are apart.
  Real gap(const ReducedModel& model, int a, int b) const {
    const LegShape &first = model.leg_shape[a], &second = model.leg_shape[b];
    if (first.is_box && second.is_box) {
      return gapOfBoxes<Real>(boxes_[a], first.half_size, boxes_[b], second.half_size);
    }
    if (second.is_box) return gapToBox(first, a, second, b);
    if (first.is_box) return gapToBox(second, b, first, a);
    Real squared =
        squaredDistance<Real>(capsules_[a], first.half_length, capsules_[b], second.half_length);
    applyParallelRule<Real>(capsules_[a], first.half_length, capsules_[b], second.half_length,
                            squared);
    return squareRoot(squared) - (first.radius + second.radius);
  }

  Real gapToBox(const LegShape& capsule, int at, const LegShape& box, int box_at) const {
    const Real squared = squaredDistanceToBox<Real>(capsules_[at], capsule.half_length,
                                                    boxes_[box_at], box.half_size);
    return squareRoot(squared) - capsule.radius;
  }

  Real clearance_[kMaxLegs][kMaxLegs];
  PlacedCapsule<Real> capsules_[kMaxLegShapes];
  PlacedBox<Real> boxes_[kMaxLegShapes];  // of the shapes that are boxes
  unsigned placed_;
};

}  // namespace hexapod::reduced
