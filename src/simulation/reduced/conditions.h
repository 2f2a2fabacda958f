#pragma once

#include "simulation/reduced/model.h"

namespace hexapod::reduced {

/// What may differ between robots of one model that are stepped together, the length of the step
/// included: each lane has its own. Symbols in brackets are those of doc/reduced_dynamics.md.
template <typename Real>
struct Conditions {
  Real step{};           ///< h [s]
  Real mass_scale{};     ///< of every mass and inertia of the model
  Real friction{};       ///< [mu]
  Real servo_gain{};     ///< [1/s]
  Vec3<Real> fall{};     ///< velocity that gravity adds in a step [m/s], in the frame of the floor
  Real joint_rate{};     ///< of the hinges' error reduction: joint_erp / h [1/s]
  Real soft_rate{};      ///< of the contacts': soft_erp / h [1/s]
  Real normal_weight{};  ///< impulse per lacking velocity of a normal row [N s / (m/s)]
  Real friction_weight{};                         ///< the same of a tangential row
  Real max_impulse[kMaxLegs][kMaxSegments] = {};  ///< of each motor in a step [N m s]
};

/// Calls use(of to, of from) for every number of the two.
template <typename Real, typename Use>
inline void forEachPair(Conditions<Real>& to, const Conditions<double>& from, const Use& use) {
  use(to.step, from.step), use(to.mass_scale, from.mass_scale);
  use(to.friction, from.friction), use(to.servo_gain, from.servo_gain);
  use(to.fall.x, from.fall.x), use(to.fall.y, from.fall.y), use(to.fall.z, from.fall.z);
  use(to.joint_rate, from.joint_rate), use(to.soft_rate, from.soft_rate);
  use(to.normal_weight, from.normal_weight), use(to.friction_weight, from.friction_weight);
  for (int leg = 0; leg < kMaxLegs; ++leg) {
    for (int s = 0; s < kMaxSegments; ++s) use(to.max_impulse[leg][s], from.max_impulse[leg][s]);
  }
}

}  // namespace hexapod::reduced
