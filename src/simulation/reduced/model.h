#pragma once

#include "simulation/reduced/algebra.h"

namespace hexapod::reduced {

/// Largest robot the engine takes.
constexpr int kMaxLegs = 12;
constexpr int kMinSegments = 2;  ///< a leg of fewer is padded
constexpr int kMaxSegments = 4;
constexpr int kMaxSpheres = 384;   ///< that can touch the floor
constexpr int kMaxLegShapes = 64;  ///< that can touch one another

/// A rigid body. Its frame has its origin at the centre of mass and the axes of the link, as the
/// body in ODE. Inertia = round * 1 + first.scale * axis axis^T + second.scale * axis axis^T.
struct BodyModel {
  struct AxisTerm {
    double scale = 0.0;  ///< [kg m^2]; 0: no such term
    Vec3<double> axis{};
  };
  double mass = 0.0;           ///< [kg]
  double round_inertia = 0.0;  ///< [kg m^2]
  AxisTerm first, second;
};

/// The hinge between a segment (child) and the body it hangs on (parent), with its servo.
struct JointModel {
  Vec3<double> parent_anchor{}, child_anchor{};  ///< [m] from the centres of mass, in body axes
  Vec3<double> parent_axis{}, child_axis{};      ///< unit
  Quaternion<double> child_from_parent{};        ///< at angle 0
  double lower = 0.0, upper = 0.0;               ///< stops [rad]
  double max_velocity = 0.0;                     ///< [rad/s]
  double reach = 0.0;  ///< [m] of the farthest point from here outwards, whatever the angles
};

/// A sphere of a body that can touch the floor: a cap of a capsule, a sphere, a corner of a box.
struct FloorSphere {
  int leg = -1;  ///< -1: of the base
  int segment = 0;
  Vec3<double> center{};  ///< [m] in the body's frame
  double radius = 0.0;    ///< [m], 0 for a corner
  bool is_corner = false;
  Vec3<double> edge[3] = {};  ///< of a corner: to those beside it [m]
};

/// A capsule (length 0: a sphere) or a box of a leg, for the test of legs against each other.
struct LegShape {
  int leg = 0;
  int segment = 0;
  bool is_box = false;
  Vec3<double> center{};                   ///< [m] in the body's frame
  Rotation<double> axes{};                 ///< a capsule lies along z
  double half_length = 0.0, radius = 0.0;  ///< of a capsule [m]
  double half_size[3] = {};                ///< of a box [m]
};

/// Everything about one robot that does not change, under whatever physics its legs are in the same
/// states: plain numbers, shared by all threads. What physics change is in Conditions. Symbols in
/// brackets are those of doc/reduced_dynamics.md.
struct ReducedModel {
  int legs = 0;
  int segments = 0;  ///< of the longest leg
  /// Of each leg. Those up to `segments` are padding: without mass or shape, on their parent, so
  /// that they move nothing and nothing moves them.
  int of_leg[kMaxLegs] = {};
  BodyModel base;
  BodyModel bodies[kMaxLegs][kMaxSegments];
  JointModel joints[kMaxLegs][kMaxSegments];
  int spheres = 0;
  FloorSphere floor[kMaxSpheres];
  int leg_shapes = 0;
  LegShape leg_shape[kMaxLegShapes];  ///< leg by leg
  int first_shape[kMaxLegs + 1] = {};

  double servo_dead_zone = 0.0;          ///< [rad/s]
  double max_correcting_velocity = 0.0;  ///< [m/s]
  Vec3<double> base_origin{};            ///< of the link, from the centre of mass [m]
  double max_base_height = 0.0;          ///< [m]
  double absurd_speed = 0.0;             ///< [m/s]: beyond is diverged
  double absurd_rate = 0.0;              ///< [rad/s]
  /// Active sets the solver tries before it gives up; what it is left with then is no motion, and
  /// the robot is diverged.
  int most_solver_rounds = 200;
};

}  // namespace hexapod::reduced
