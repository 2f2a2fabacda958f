#pragma once

#include "simulation/reduced/angle.h"
#include "simulation/reduced/state.h"

namespace hexapod::reduced {

/// The parts of a step that follow from the poses alone; section numbers are those of
/// doc/reduced_dynamics.md.

/// Where a body is (2): its axes, and its centre of mass seen from the origin O of the closed tree.
template <typename Real>
struct Placement {
  Rotation<Real> world_from_body;
  Vec3<Real> arm;  ///< rho [m]: O is the base's centre of mass; as if the joints had no gaps
};

/// A hinge in the world (2, 3).
template <typename Real>
struct Hinge {
  Spatial<Real> motion;  ///< S: velocity of the child per unit of joint velocity
  Vec3<Real> anchor;     ///< r [m] from O, in the closed tree
  Real angle;            ///< [rad] as ODE reads it
};

template <typename Real>
inline Placement<Real> place(const BodyState<Real>& base) {
  return {rotationOf(base.rotation), zeroVec3<Real>()};
}

/// Places the child of a hinge and the hinge itself; adds the hinge's error reduction, `rate` =
/// joint_erp / h, to that of the parent.
template <typename Real>
inline void placeSegment(const JointModel& joint, const BodyState<Real>& parent_state,
                         const Placement<Real>& parent, const BodyState<Real>& state,
                         const Real& rate, Placement<Real>& placement, Hinge<Real>& hinge,
                         Spatial<Real>& correction) {
  placement.world_from_body = rotationOf(state.rotation);
  const Vec3<Real> from_parent = parent.world_from_body * joint.parent_anchor;
  const Vec3<Real> from_child = placement.world_from_body * joint.child_anchor;
  hinge.anchor = parent.arm + from_parent;
  placement.arm = hinge.anchor - from_child;

  const Vec3<Real> axis = placement.world_from_body * joint.child_axis;
  hinge.motion = {axis, cross(hinge.anchor, axis)};
  hinge.angle =
      hingeAngle(state.rotation, parent_state.rotation, joint.child_from_parent, joint.child_axis);

  const Vec3<Real> gap = (parent_state.position + from_parent) - (state.position + from_child);
  const Vec3<Real> tilt = cross(axis, parent.world_from_body * joint.parent_axis);
  const Vec3<Real> turn = rate * tilt;
  correction = correction + Spatial<Real>{turn, rate * gap + cross(hinge.anchor, turn)};
}

}  // namespace hexapod::reduced
