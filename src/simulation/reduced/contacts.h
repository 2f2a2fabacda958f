#pragma once

#include "simulation/reduced/tree.h"

namespace hexapod::reduced {

/// One sphere on the floor (7): three rows, velocity of the contact point along x, y (friction) and
/// z (normal). In a batch: of all robots whose sphere touches; the others' weights are zero.
template <typename Real, int kSegments>
struct FloorContact {
  int leg, segment;  ///< leg -1: the base
  Mask<Real> touching;
  Vec3<Real> arm;               ///< chi: of the contact point from O, in the closed tree
  Vec3<Real> lever[kSegments];  ///< t: velocity of the point per unit of joint velocity
  Vec3<Real> wanted;            ///< b: velocity the rows ask of base and deviating joints [m/s]
  Vec3<Real> impulse;           ///< of the rows that are at a bound [N s]
  Real friction_bound;          ///< of either tangent [N s]
  Mask<Real> free_x, free_y, free_z;  ///< rows between their bounds
};

template <typename Real, int kSegments>
struct FloorContacts {
  int count = 0;
  Mask<Real> base_touches;
  FloorContact<Real, kSegments> contact[kMaxSpheres];
};

/// Levers and wanted velocity of a contact of a leg (7).
template <typename Real, int kSegments>
inline void couple(const LegTerms<Real, kSegments>& leg, FloorContact<Real, kSegments>& contact) {
  contact.wanted = contact.wanted - velocityAt(leg.correction[contact.segment], contact.arm);
  for (int s = 0; s <= contact.segment; ++s) {
    contact.lever[s] = velocityAt(leg.hinge[s].motion, contact.arm);
    contact.wanted = contact.wanted - leg.velocity[s] * contact.lever[s];
  }
  for (int s = contact.segment + 1; s < kSegments; ++s) contact.lever[s] = zeroVec3<Real>();
}

template <typename Real, int kSegments>
inline void addContact(const ReducedModel& model, const FloorSphere& sphere,
                       const Conditions<Real>& conditions, const Vec3<Real>& to_center,
                       const Vec3<Real>& arm, const Real& depth,
                       const TreeTerms<Real, kSegments>& tree,
                       FloorContacts<Real, kSegments>& contacts) {
  FloorContact<Real, kSegments>& contact = contacts.contact[contacts.count++];
  contact.leg = sphere.leg;
  contact.segment = sphere.segment;
  contact.touching = depth >= 0.0;
  contact.arm = arm + to_center;
  contact.arm.z = contact.arm.z - sphere.radius;
  const Real limit = splat<Real>(model.max_correcting_velocity);
  contact.wanted = zeroVec3<Real>();
  contact.wanted.z = smaller<Real>(conditions.soft_rate * depth, limit);
  contact.impulse = zeroVec3<Real>();
  contact.friction_bound = Real();
  if (sphere.leg >= 0) {
    couple(tree.leg[sphere.leg], contact);
  } else {
    for (Vec3<Real>& lever : contact.lever) lever = zeroVec3<Real>();
    contacts.base_touches = contacts.base_touches | contact.touching;
  }
}

/// Where a corner is on the upper side of its box: above that edge of it which is the steepest. A
/// box rests on the corners of one side only, as in ODE.
template <typename Real>
inline Mask<Real> onUpperSide(const FloorSphere& corner, const Rotation<Real>& axes) {
  Real rise = Real();
  for (const Vec3<double>& edge : corner.edge) {
    const Real of_edge = axes.x.z * edge.x + axes.y.z * edge.y + axes.z.z * edge.z;
    rise = select<Real>(magnitude(of_edge) > magnitude(rise), of_edge, rise);
  }
  return rise < 0.0;
}

/// All spheres at or below the floor at the poses the step starts from (7).
template <typename Real, int kSegments>
inline void findContacts(const ReducedModel& model, const Conditions<Real>& conditions,
                         const State<Real>& state, const TreeTerms<Real, kSegments>& tree,
                         FloorContacts<Real, kSegments>& contacts) {
  contacts.count = 0;
  contacts.base_touches = noLanes<Real>();
  for (int i = 0; i < model.spheres; ++i) {
    const FloorSphere& sphere = model.floor[i];
    const bool of_base = sphere.leg < 0;
    const BodyState<Real>& body = of_base ? state.base : state.segment[sphere.leg][sphere.segment];
    const Placement<Real>& placement =
        of_base ? tree.base : tree.leg[sphere.leg].placement[sphere.segment];
    const Rotation<Real>& axes = placement.world_from_body;
    const Vec3<double>& center = sphere.center;
    const Real up = axes.x.z * center.x + axes.y.z * center.y + axes.z.z * center.z;
    Real depth = sphere.radius - (body.position.z + up);
    if (!any<Real>(depth >= 0.0)) continue;
    if (sphere.is_corner) {
      depth = select<Real>(onUpperSide(sphere, axes), splat<Real>(-1.0), depth);
      if (!any<Real>(depth >= 0.0)) continue;
    }
    addContact(model, sphere, conditions, axes * center, placement.arm, depth, tree, contacts);
  }
}

}  // namespace hexapod::reduced
