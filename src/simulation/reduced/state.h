#pragma once

#include "simulation/reduced/model.h"

namespace hexapod::reduced {

/// The state ODE keeps of a body, too: where its centre of mass is and how it moves, in the world.
template <typename Real>
struct BodyState {
  Vec3<Real> position;        ///< [m]
  Quaternion<Real> rotation;  ///< world_from_body
  Vec3<Real> velocity;        ///< [m/s]
  Vec3<Real> rate;            ///< angular velocity [rad/s]
};

/// All bodies in maximal coordinates, because the small gaps of the joints are part of the state,
/// and the servos' targets. Real = Lanes<n>: of n robots.
template <typename Real>
struct State {
  BodyState<Real> base;
  BodyState<Real> segment[kMaxLegs][kMaxSegments];
  Real target[kMaxLegs][kMaxSegments];  ///< [rad]
};

template <typename Body, typename Use>
inline void forEachValueOf(Body& body, const Use& use) {
  use(body.position.x), use(body.position.y), use(body.position.z);
  use(body.rotation.w), use(body.rotation.x), use(body.rotation.y), use(body.rotation.z);
  use(body.velocity.x), use(body.velocity.y), use(body.velocity.z);
  use(body.rate.x), use(body.rate.y), use(body.rate.z);
}

/// Calls use(value) for every number of a State, const or not, in the order of OdeWorld::state():
/// per body (base, then segments in joint order) position, quaternion, velocity, rate; then the
/// targets.
template <typename AnyState, typename Use>
inline void forEachValue(const ReducedModel& model, AnyState& state, const Use& use) {
  forEachValueOf(state.base, use);
  for (int leg = 0; leg < model.legs; ++leg) {
    for (int s = 0; s < model.of_leg[leg]; ++s) forEachValueOf(state.segment[leg][s], use);
  }
  for (int leg = 0; leg < model.legs; ++leg) {
    for (int s = 0; s < model.of_leg[leg]; ++s) use(state.target[leg][s]);
  }
}

}  // namespace hexapod::reduced
