#pragma once

#include "simulation/reduced/conditions.h"
#include "simulation/reduced/kinematics.h"

namespace hexapod::reduced {

/// Inertia of one or several bodies about O (4): mass, first moment, second moment.
template <typename Real>
struct Inertia {
  Real mass;           ///< [kg]
  Vec3<Real> moment;   ///< sum of m rho [kg m]
  Sym3<Real> angular;  ///< [kg m^2]
};

template <typename Real>
inline Inertia<Real> operator+(const Inertia<Real>& a, const Inertia<Real>& b) {
  return {a.mass + b.mass, a.moment + b.moment, a.angular + b.angular};
}

/// Momentum about O of everything moving with `motion`.
template <typename Real>
inline Spatial<Real> operator*(const Inertia<Real>& inertia, const Spatial<Real>& motion) {
  return {inertia.angular * motion.angular + cross(inertia.moment, motion.linear),
          inertia.mass * motion.linear - cross(inertia.moment, motion.angular)};
}

/// Inertia about the centre of mass, in world axes, with `scale` times the body's own.
template <typename Real>
inline Sym3<Real> worldInertia(const BodyModel& body, const Real& scale,
                               const Rotation<Real>& world_from_body) {
  const Real round = body.round_inertia * scale;
  Sym3<Real> inertia{round, round, round, Real(), Real(), Real()};
  for (const BodyModel::AxisTerm* term : {&body.first, &body.second}) {
    if (term->scale == 0.0) continue;
    inertia = inertia + outerSquare(Real(term->scale * scale), world_from_body * term->axis);
  }
  return inertia;
}

/// Change of angular momentum [N m s] by ODE's implicit gyroscopic torque over one step (4):
/// h L x w', where (I - h [L]x) w' = L.
template <typename Real>
inline Vec3<Real> gyroscopicImpulse(const Sym3<Real>& inertia, const Vec3<Real>& momentum,
                                    const Real& step) {
  const Vec3<Real> l = step * momentum;
  const Vec3<Real> first{inertia.xx, inertia.xy - l.z, inertia.xz + l.y};
  const Vec3<Real> second{inertia.xy + l.z, inertia.yy, inertia.yz - l.x};
  const Vec3<Real> third{inertia.xz - l.y, inertia.yz + l.x, inertia.zz};
  const Vec3<Real> across = cross(second, third);
  const Real scale = 1.0 / dot(first, across);
  const Vec3<Real> rate{dot(across, momentum), dot(cross(third, first), momentum),
                        dot(cross(first, second), momentum)};
  return scale * cross(l, rate);
}

/// What a body brings into the equations (4): its inertia about O, and the momentum it would have
/// without hinges and contacts at the end of the step, less what the corrections take.
template <typename Real>
inline void bodyTerms(const BodyModel& body, const Conditions<Real>& conditions,
                      const BodyState<Real>& state, const Placement<Real>& placement,
                      const Spatial<Real>& correction, Inertia<Real>& inertia,
                      Spatial<Real>& momentum) {
  const Vec3<Real>& arm = placement.arm;
  const Real mass = body.mass * conditions.mass_scale;
  const Sym3<Real> about_center =
      worldInertia(body, conditions.mass_scale, placement.world_from_body);
  inertia = {mass, mass * arm, about_center + steiner(mass, arm)};

  const Vec3<Real> spin = about_center * state.rate;
  const Vec3<Real> falling = state.velocity + conditions.fall;
  momentum.linear = mass * (falling - velocityAt(correction, arm));
  momentum.angular = spin + gyroscopicImpulse(about_center, spin, conditions.step) -
                     about_center * correction.angular + cross(arm, momentum.linear);
}

}  // namespace hexapod::reduced
