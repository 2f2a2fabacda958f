#pragma once

#include "simulation/reduced/clearance.h"
#include "simulation/reduced/solver.h"

namespace hexapod::reduced {

/// What a step sees at the poses it starts from, and whether the state it ends in is absurd.
template <typename Real>
struct StepFindings {
  Mask<Real> fell;
  Mask<Real> collided;  ///< two legs touch
  Mask<Real> diverged;
};

/// Workspace of a step; of it only the clearance of the legs lasts from one step to the next.
template <typename Real, int kSegments>
struct StepWorkspace {
  TreeTerms<Real, kSegments> tree;
  FloorContacts<Real, kSegments> contacts;
  Solver<Real, kSegments> solver;
  LegClearance<Real> clearance;
};

/// Positions with the new velocities, as ODE's dxStepBody: q += h/2 (0, w) q, normalised (9).
template <typename Real>
inline void integrate(const Real& step, BodyState<Real>& body) {
  body.position = body.position + step * body.velocity;
  const Vec3<Real> half = Real(0.5 * step) * body.rate;
  const Quaternion<Real> q = body.rotation;
  const Quaternion<Real> moved{q.w - (half.x * q.x + half.y * q.y + half.z * q.z),
                               q.x + (half.x * q.w + half.y * q.z - half.z * q.y),
                               q.y + (half.y * q.w + half.z * q.x - half.x * q.z),
                               q.z + (half.z * q.w + half.x * q.y - half.y * q.x)};
  const Real norm = moved.w * moved.w + moved.x * moved.x + moved.y * moved.y + moved.z * moved.z;
  const Real scale = 1.0 / squareRoot(norm);
  body.rotation = {moved.w * scale, moved.x * scale, moved.y * scale, moved.z * scale};
}

/// Velocities of all bodies from those of base and joints, and with them the new positions (9).
template <typename Real, int kSegments>
inline void moveBodies(const ReducedModel& model, const Real& step,
                       const StepWorkspace<Real, kSegments>& work, State<Real>& state) {
  const Spatial<Real>& base = work.solver.baseMotion();
  state.base.velocity = base.linear;
  state.base.rate = base.angular;
  integrate(step, state.base);
  for (int i = 0; i < model.legs; ++i) {
    const LegTerms<Real, kSegments>& leg = work.tree.leg[i];
    Spatial<Real> motion = base;
    for (int s = 0; s < kSegments; ++s) {
      const Real joint_velocity = leg.velocity[s] + work.solver.deviation(i, s);
      motion = motion + joint_velocity * leg.hinge[s].motion;
      const Spatial<Real> corrected = motion + leg.correction[s];
      BodyState<Real>& body = state.segment[i][s];
      body.rate = corrected.angular;
      body.velocity = velocityAt(corrected, leg.placement[s].arm);
      integrate(step, body);
    }
  }
}

/// Bound on how far any point of each leg moves relative to the base in this step [m].
template <typename Real, int kSegments>
inline void useClearance(const ReducedModel& model, const Real& step,
                         StepWorkspace<Real, kSegments>& work) {
  // Steps are straight, joints turn: a few per cent more; gaps of the joints close slowly.
  constexpr double kMore = 1.25, kGaps = 5e-5;
  Real travel[kMaxLegs];
  for (int i = 0; i < model.legs; ++i) {
    travel[i] = splat<Real>(kGaps);
    for (int s = 0; s < kSegments; ++s) {
      const Real velocity = work.tree.leg[i].velocity[s] + work.solver.deviation(i, s);
      travel[i] = travel[i] + kMore * step * model.joints[i][s].reach * magnitude(velocity);
    }
  }
  work.clearance.use(model, travel);
}

/// Not finite or faster than `speed` and `rate`: comparisons with NaN are false.
template <typename Real>
inline Mask<Real> sane(const BodyState<Real>& body, double speed, double rate) {
  const Real norm = dot(body.position, body.position);
  return (dot(body.velocity, body.velocity) <= speed * speed) &
         (dot(body.rate, body.rate) <= rate * rate) & (norm - norm == 0.0);
}

template <typename Real>
inline Mask<Real> absurd(const ReducedModel& model, const State<Real>& state) {
  Mask<Real> good = sane(state.base, model.absurd_speed, model.absurd_rate);
  for (int leg = 0; leg < model.legs; ++leg) {
    for (int s = 0; s < model.segments; ++s) {
      good = good & sane(state.segment[leg][s], model.absurd_speed, model.absurd_rate);
    }
  }
  return notMask<Real>(good);
}

/// One step, in each lane as long as its conditions say: what OdeWorld::step() does, in the same
/// order (doc, "Order of a step").
template <typename Real, int kSegments>
inline StepFindings<Real> advance(const ReducedModel& model, const Conditions<Real>& conditions,
                                  StepWorkspace<Real, kSegments>& work, State<Real>& state) {
  StepFindings<Real> findings;
  assembleTree(model, conditions, state, work.tree);
  findContacts(model, conditions, state, work.tree, work.contacts);
  const Rotation<Real>& axes = work.tree.base.world_from_body;
  const Real height = state.base.position.z + (axes * model.base_origin).z;
  findings.fell = work.contacts.base_touches | notMask<Real>(height <= model.max_base_height) |
                  notMask<Real>(axes.z.z >= 0.0);
  findings.collided = work.clearance.touching(model, state, work.tree);
  work.solver.solve(model, conditions, work.tree, work.contacts);
  moveBodies(model, conditions.step, work, state);
  useClearance(model, conditions.step, work);
  findings.diverged = absurd(model, state) | work.solver.gaveUp();
  return findings;
}

}  // namespace hexapod::reduced
