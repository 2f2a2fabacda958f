#pragma once

#include <algorithm>

#include "simulation/reduced/inertia.h"

namespace hexapod::reduced {

/// One leg's share of the equations of a step (5). `kSegments` hinges.
template <typename Real, int kSegments>
struct LegTerms {
  Placement<Real> placement[kSegments];
  Hinge<Real> hinge[kSegments];
  Spatial<Real> correction[kSegments];  ///< d of each segment
  Spatial<Real> coupling[kSegments];    ///< F: column of H between base and hinge
  Real inertia[kSegments][kSegments];   ///< H of the leg's hinges, lower triangle
  Real momentum[kSegments];             ///< r: right-hand side of the hinges' rows
  Real velocity[kSegments];             ///< wanted joint velocity [rad/s]: of the motor or the stop
  Real low[kSegments], high[kSegments];  ///< bounds of its impulse [N m s]
};

/// Everything of a step that is known before the contact problem is solved.
template <typename Real, int kSegments>
struct TreeTerms {
  Placement<Real> base;
  Inertia<Real> inertia;   ///< of the whole robot about O: H's block of the base
  Spatial<Real> momentum;  ///< r of the base's rows
  LegTerms<Real, kSegments> leg[kMaxLegs];
};

/// The servo as a motor row, or the stop when the angle is beyond one (6, ODE's addLimot).
template <typename Real, int kSegments>
inline void driveHinge(const ReducedModel& model, const Conditions<Real>& conditions, int index,
                       int s, const Real& target, LegTerms<Real, kSegments>& leg) {
  const JointModel& joint = model.joints[index][s];
  const Real& angle = leg.hinge[s].angle;
  const Real wanted = conditions.servo_gain * (target - angle);
  const Real limit = splat<Real>(joint.max_velocity);
  Real velocity = smaller<Real>(larger<Real>(wanted, -limit), limit);
  velocity = select<Real>(magnitude(wanted) < model.servo_dead_zone, Real(), velocity);
  const Real& impulse = conditions.max_impulse[index][s];
  leg.velocity[s] = velocity;
  leg.low[s] = -impulse;
  leg.high[s] = impulse;

  const Mask<Real> below = angle <= joint.lower;
  const Mask<Real> above = notMask<Real>(below) & (angle >= joint.upper);
  if (!any<Real>(below | above)) return;
  // At a stop the motor pushes with all it has and the row is the stop's.
  const Mask<Real> forward = (velocity > 0.0) | ((velocity == 0.0) & above);
  const Real push = select<Real>(forward, impulse, -impulse);
  const Real beyond = select<Real>(below, angle - joint.lower, angle - joint.upper);
  const Mask<Real> stopped = below | above;
  leg.momentum[s] = leg.momentum[s] + select<Real>(stopped, push, Real());
  leg.velocity[s] = select<Real>(stopped, -conditions.joint_rate * beyond, velocity);
  leg.low[s] = select<Real>(below, Real(), select<Real>(above, splat<Real>(-1e300), -impulse));
  leg.high[s] = select<Real>(above, Real(), select<Real>(below, splat<Real>(1e300), impulse));
}

/// H and r of one leg (5), from the tip inwards; adds the leg to the whole robot.
template <typename Real, int kSegments>
inline void composeLeg(Inertia<Real> (&inertia)[kSegments], Spatial<Real> (&momentum)[kSegments],
                       LegTerms<Real, kSegments>& leg, TreeTerms<Real, kSegments>& tree) {
  for (int s = kSegments - 1; s >= 0; --s) {
    if (s + 1 < kSegments) {
      inertia[s] = inertia[s] + inertia[s + 1];
      momentum[s] = momentum[s] + momentum[s + 1];
    }
    leg.coupling[s] = inertia[s] * leg.hinge[s].motion;
    leg.momentum[s] = dot(leg.hinge[s].motion, momentum[s]);
    for (int t = 0; t <= s; ++t) leg.inertia[s][t] = dot(leg.hinge[t].motion, leg.coupling[s]);
  }
  tree.inertia = tree.inertia + inertia[0];
  tree.momentum = tree.momentum + momentum[0];
}

template <typename Real, int kSegments>
inline void assembleLeg(const ReducedModel& model, const Conditions<Real>& conditions,
                        const State<Real>& state, int index, TreeTerms<Real, kSegments>& tree) {
  LegTerms<Real, kSegments>& leg = tree.leg[index];
  Inertia<Real> inertia[kSegments];
  Spatial<Real> momentum[kSegments];
  Spatial<Real> correction = zeroSpatial<Real>();
  for (int s = 0; s < kSegments; ++s) {
    const BodyState<Real>& parent = s == 0 ? state.base : state.segment[index][s - 1];
    const BodyState<Real>& body = state.segment[index][s];
    placeSegment(model.joints[index][s], parent, s == 0 ? tree.base : leg.placement[s - 1], body,
                 conditions.joint_rate, leg.placement[s], leg.hinge[s], correction);
    leg.correction[s] = correction;
    bodyTerms(model.bodies[index][s], conditions, body, leg.placement[s], correction, inertia[s],
              momentum[s]);
  }
  composeLeg(inertia, momentum, leg, tree);
  for (int s = 0; s < kSegments; ++s) {
    driveHinge(model, conditions, index, s, state.target[index][s], leg);
  }
}

/// Fills `tree` from the state (2 to 6).
template <typename Real, int kSegments>
inline void assembleTree(const ReducedModel& model, const Conditions<Real>& conditions,
                         const State<Real>& state, TreeTerms<Real, kSegments>& tree) {
  tree.base = place(state.base);
  bodyTerms(model.base, conditions, state.base, tree.base, zeroSpatial<Real>(), tree.inertia,
            tree.momentum);
  for (int leg = 0; leg < model.legs; ++leg) assembleLeg(model, conditions, state, leg, tree);
}

}  // namespace hexapod::reduced
