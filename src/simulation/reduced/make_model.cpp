#include "simulation/reduced/make_model.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "simulation/kinematics.h"
#include "simulation/physics.h"

namespace hexapod::reduced {
namespace {

constexpr double kMinCompliance = 1e-6;  // of contacts: they are springs to this engine
constexpr double kMaxJointCfm = 1e-7;    // of hinges and motors: they are rigid to it

// Of segments that are not there: lost in the rounding of everything else, but not 0 / 0.
constexpr double kNoInertia_kg_m2 = 1e-30;
constexpr double kPaddingTorque_nm = 1.0;

Vec3<double> vec3(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

// Drops an axis on which the inertia is the round part already.
BodyModel::AxisTerm axisTerm(double moment, double round, const Eigen::Vector3d& axis) {
  const double scale = moment - round;
  return {std::abs(scale) > 1e-12 * round ? scale : 0.0, vec3(axis)};
}

BodyModel makeBody(const Body& body) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(body.inertia_kg_m2);
  const Eigen::Vector3d& moment = principal.eigenvalues();  // ascending
  // Of the two equal moments of a body of revolution one is taken as the round part.
  const bool upper_pair = moment(2) - moment(1) < moment(1) - moment(0);
  const int round = upper_pair ? 2 : 0;
  const int far = 2 - round;
  BodyModel made;
  made.mass = body.mass_kg;
  made.round_inertia = moment(round);
  made.first = axisTerm(moment(far), moment(round), principal.eigenvectors().col(far));
  made.second = axisTerm(moment(1), moment(round), principal.eigenvectors().col(1));
  return made;
}

JointModel makeJoint(const Joint& joint, const Body& parent, const Body& child) {
  const Eigen::Matrix3d parent_from_child = joint.parent_from_joint.linear();
  const Eigen::Quaterniond turn(Eigen::Matrix3d(parent_from_child.transpose()));
  JointModel made;
  made.parent_anchor = vec3(joint.parent_from_joint.translation() - parent.center_of_mass_m);
  made.child_anchor = vec3(-child.center_of_mass_m);
  made.parent_axis = vec3(parent_from_child * joint.axis);
  made.child_axis = vec3(joint.axis);
  made.child_from_parent = {turn.w(), turn.x(), turn.y(), turn.z()};
  made.lower = joint.lower_rad;
  made.upper = joint.upper_rad;
  made.max_velocity = joint.max_velocity_rad_per_s;
  return made;
}

// A hinge of a segment that its leg does not have. Its motor, of kPaddingTorque_nm, never feels
// anything.
JointModel padding() {
  JointModel made;
  made.parent_axis = made.child_axis = {0.0, 0.0, 1.0};
  made.child_from_parent = {1.0, 0.0, 0.0, 0.0};
  made.lower = -1.0;
  made.upper = 1.0;
  made.max_velocity = 1.0;
  return made;
}

FloorSphere cornerOf(const Shape& box, int corner) {
  const Eigen::Vector3d sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
  FloorSphere made;
  made.center = vec3(box.body_from_shape * (0.5 * box.size_m.cwiseProduct(sign)));
  made.is_corner = true;
  for (int axis = 0; axis < 3; ++axis) {
    made.edge[axis] =
        vec3(-sign[axis] * (box.size_m[axis] * box.body_from_shape.linear().col(axis)));
  }
  return made;
}

FloorSphere capOf(const Shape& capsule, double side) {
  FloorSphere made;
  made.center =
      vec3(capsule.body_from_shape * (0.5 * side * capsule.length_m * Eigen::Vector3d::UnitZ()));
  made.radius = capsule.radius_m;
  return made;
}

// Where on the floor this shape can rest, in the frame of its link.
std::vector<FloorSphere> floorSpheres(const Shape& shape) {
  std::vector<FloorSphere> spheres;
  switch (shape.kind) {
    case Shape::Kind::kBox:
      for (int corner = 0; corner < 8; ++corner) spheres.push_back(cornerOf(shape, corner));
      break;
    case Shape::Kind::kCapsule:
      spheres = {capOf(shape, 1.0), capOf(shape, -1.0)};
      break;
    case Shape::Kind::kSphere:
      spheres = {capOf(shape, 0.0)};
      break;
  }
  return spheres;
}

std::vector<FloorSphere> floorSpheres(const Body& body, int leg, int segment) {
  std::vector<FloorSphere> spheres;
  for (const Shape& shape : body.shapes) {
    for (FloorSphere sphere : floorSpheres(shape)) {
      sphere.leg = leg;
      sphere.segment = segment;
      sphere.center = sphere.center - vec3(body.center_of_mass_m);
      spheres.push_back(sphere);
    }
  }
  return spheres;
}

void addSpheres(const std::vector<FloorSphere>& spheres, ReducedModel& model) {
  for (const FloorSphere& sphere : spheres) model.floor[model.spheres++] = sphere;
}

void addLegShapes(const Body& body, int leg, int segment, ReducedModel& model) {
  for (const Shape& shape : body.shapes) {
    const Eigen::Matrix3d axes = shape.body_from_shape.linear();
    LegShape made;
    made.leg = leg;
    made.segment = segment;
    made.is_box = shape.kind == Shape::Kind::kBox;
    made.center = vec3(shape.body_from_shape.translation() - body.center_of_mass_m);
    made.axes = {vec3(axes.col(0)), vec3(axes.col(1)), vec3(axes.col(2))};
    made.half_length = shape.kind == Shape::Kind::kCapsule ? 0.5 * shape.length_m : 0.0;
    made.radius = shape.radius_m;
    for (int axis = 0; axis < 3; ++axis) made.half_size[axis] = 0.5 * shape.size_m[axis];
    model.leg_shape[model.leg_shapes++] = made;
  }
}

// From the tip inwards: the farthest a point of a segment or beyond can be from its hinge.
void addReach(const Leg& leg, int index, ReducedModel& model) {
  double beyond = 0.0;
  for (int s = model.of_leg[index] - 1; s >= 0; --s) {
    double reach = 0.0;
    for (const Shape& shape : leg.segments[s].body.shapes) {
      reach = std::max(reach, shape.body_from_shape.translation().norm() + 0.5 * shape.length_m +
                                  shape.radius_m + 0.5 * shape.size_m.norm());
    }
    model.joints[index][s].reach = std::max(reach, beyond);
    beyond =
        model.joints[index][s].reach + leg.segments[s].joint.parent_from_joint.translation().norm();
  }
}

void addBounds(const RobotDescription& robot, ReducedModel& model) {
  model.servo_dead_zone = robot.servo.dead_zone_rad_per_s;
  model.max_correcting_velocity = robot.contact.max_correcting_velocity_m_per_s;
  model.max_base_height = robot.failure.max_base_height_m;
  model.absurd_speed = kAbsurdSpeed_m_per_s;
  model.absurd_rate = kAbsurdRate_rad_per_s;
}

std::string legProblem(const RobotDescription& robot) {
  if (robot.legs.empty() || robot.legs.size() > kMaxLegs) {
    return "the number of legs must be 1 to " + std::to_string(kMaxLegs) + ", found " +
           std::to_string(robot.legs.size());
  }
  for (const Leg& leg : robot.legs) {
    const std::size_t found = leg.segments.size();
    if (found < 1 || found > kMaxSegments) {
      return "legs must have 1 to " + std::to_string(kMaxSegments) + " joints, but leg '" +
             leg.name + "' has " + std::to_string(found);
    }
    for (const Segment& segment : leg.segments) {
      if (segment.joint.lower_rad < segment.joint.upper_rad) continue;
      return "joint '" + segment.joint.name + "' must have room between its limits";
    }
  }
  return "";
}

std::string shapeProblem(const RobotDescription& robot) {
  std::size_t spheres = floorSpheres(robot.base, -1, 0).size();
  std::size_t leg_shapes = 0;
  for (const Leg& leg : robot.legs) {
    for (const Segment& segment : leg.segments) {
      spheres += floorSpheres(segment.body, 0, 0).size();
      leg_shapes += segment.body.shapes.size();
    }
  }
  if (spheres <= kMaxSpheres && leg_shapes <= kMaxLegShapes) return "";
  return "there are too many collision shapes: " + std::to_string(leg_shapes) +
         " on the legs (at most " + std::to_string(kMaxLegShapes) + ") with " +
         std::to_string(spheres) + " corners and caps in all (at most " +
         std::to_string(kMaxSpheres) + ")";
}

std::string contactProblem(const Contact& contact) {
  if (contact.soft_cfm < kMinCompliance || contact.slip_per_n_s < kMinCompliance) {
    return "contact must be compliant: soft_cfm and slip_per_n_s at least 1e-6";
  }
  if (contact.joint_cfm > kMaxJointCfm) return "joint_cfm must be at most 1e-7";
  return "";
}

}  // namespace

std::string whyNotCovered(const RobotDescription& robot) {
  std::string reason = legProblem(robot);
  if (reason.empty()) reason = shapeProblem(robot);
  if (reason.empty()) reason = contactProblem(robot.contact);
  if (reason.empty()) return "";
  return "The reduced engine does not cover robot '" + robot.name + "': " + reason +
         "; use engine ode.";
}

ReducedModel makeModel(const RobotDescription& robot, const Physics& physics) {
  const std::string reason = whyNotCovered(robot);
  if (!reason.empty()) throw std::invalid_argument(reason);
  checkPhysics(physics);
  // Mass is of the conditions: a body's axes shall not depend on it, not even by rounding.
  Physics of_unit_mass = physics;
  of_unit_mass.mass_scale = 1.0;
  const RobotDescription scaled = underPhysics(robot, of_unit_mass);
  ReducedModel model;
  model.legs = static_cast<int>(scaled.legs.size());
  model.segments = kMinSegments;
  for (int leg = 0; leg < model.legs; ++leg) {
    model.of_leg[leg] = static_cast<int>(scaled.legs[leg].segments.size());
    model.segments = std::max(model.segments, model.of_leg[leg]);
  }
  model.base = makeBody(scaled.base);
  model.base_origin = vec3(-scaled.base.center_of_mass_m);
  addBounds(scaled, model);
  addSpheres(floorSpheres(scaled.base, -1, 0), model);
  for (int leg = 0; leg < model.legs; ++leg) {
    const Body* parent = &scaled.base;
    for (int s = 0; s < model.of_leg[leg]; ++s) {
      const Segment& segment = scaled.legs[leg].segments[s];
      model.bodies[leg][s] = makeBody(segment.body);
      model.joints[leg][s] = makeJoint(segment.joint, *parent, segment.body);
      addSpheres(floorSpheres(segment.body, leg, s), model);
      if (touchCounts(physics, leg)) addLegShapes(segment.body, leg, s, model);
      parent = &segment.body;
    }
    for (int s = model.of_leg[leg]; s < model.segments; ++s) {
      model.joints[leg][s] = padding();
      model.bodies[leg][s].round_inertia = kNoInertia_kg_m2;
    }
    addReach(scaled.legs[leg], leg, model);
    model.first_shape[leg + 1] = model.leg_shapes;
  }
  return model;
}

Conditions<double> conditionsOf(const RobotDescription& robot, const Physics& physics,
                                double step_s) {
  const RobotDescription scaled = underPhysics(robot, physics);
  const Eigen::Vector3d gravity = gravityOnFloor(physics);
  Conditions<double> conditions;
  conditions.step = step_s;
  conditions.mass_scale = physics.mass_scale;
  conditions.friction = scaled.contact.friction;
  conditions.servo_gain = scaled.servo.gain_per_s;
  conditions.fall = {step_s * gravity.x(), step_s * gravity.y(), step_s * gravity.z()};
  conditions.joint_rate = scaled.contact.joint_erp / step_s;
  conditions.soft_rate = scaled.contact.soft_erp / step_s;
  // A row's compliance is cfm / h.
  conditions.normal_weight = step_s / scaled.contact.soft_cfm;
  conditions.friction_weight = step_s / scaled.contact.slip_per_n_s;
  for (std::size_t leg = 0; leg < scaled.legs.size(); ++leg) {
    double* impulse = conditions.max_impulse[leg];
    std::fill_n(impulse, kMaxSegments, step_s * kPaddingTorque_nm);
    for (const Segment& segment : scaled.legs[leg].segments) {
      *impulse++ = step_s * segment.joint.max_torque_nm;
    }
  }
  return conditions;
}

Eigen::Isometry3d worldFromBase(const ReducedModel& model, const double* v) {
  const Rotation<double> axes = rotationOf(Quaternion<double>{v[3], v[4], v[5], v[6]});
  const Vec3<double> origin = axes * model.base_origin;
  Eigen::Isometry3d world_from_base = Eigen::Isometry3d::Identity();
  world_from_base.linear() << axes.x.x, axes.y.x, axes.z.x,  //
      axes.x.y, axes.y.y, axes.z.y,                          //
      axes.x.z, axes.y.z, axes.z.z;
  world_from_base.translation() << v[0] + origin.x, v[1] + origin.y, v[2] + origin.z;
  return world_from_base;
}

}  // namespace hexapod::reduced
