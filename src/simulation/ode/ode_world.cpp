#include "simulation/ode/ode_world.h"

#include <ode/ode.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <stdexcept>

#include "simulation/kinematics.h"
#include "simulation/physics.h"
#include "simulation/standing_state.h"

// ODE lives in this one file: the library's life, a robot built in it, and the world around that.

namespace hexapod {
namespace {

constexpr int kMaxContactsPerPair = 10;

// A step that dSolveLCP gives up on is tried again with uneven contacts: first this uneven, then
// ten times as much, and so on.
constexpr double kLeastUnevenness = 1e-9;
constexpr int kMostTries = 5;

// ODE ends the process when an error handler returns.
struct OdeFailure : std::runtime_error {
  OdeFailure() : std::runtime_error("ODE stopped on an internal error") {}
};

[[noreturn]] void throwFailure(int, const char*, va_list) { throw OdeFailure(); }

// dSolveLCP tells nobody but the message handler that it gave up.
thread_local bool lcp_gave_up = false;
void noteMessage(int number, const char*, va_list) { lcp_gave_up |= number == d_ERR_LCP; }

class OdeLibrary {
 public:
  // Opens ODE with the first call in the process, closes it at exit; sets up the calling thread.
  static void prepareThread() {
    static const OdeLibrary library;
    thread_local const bool ready = dAllocateODEDataForThread(dAllocateMaskAll) != 0;
    if (!ready) throw std::runtime_error("ODE has no memory left for a thread's data.");
  }

 private:
  OdeLibrary() {
    dInitODE2(0);
    dSetErrorHandler(&throwFailure);
    dSetDebugHandler(&throwFailure);
    dSetMessageHandler(&noteMessage);
  }
  ~OdeLibrary() { dCloseODE(); }
};

Eigen::Vector3d vector(const dReal* values) { return {values[0], values[1], values[2]}; }

Eigen::Matrix3d rotation(const dReal* rows_of_four) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>, 0, Eigen::OuterStride<4>>(
      rows_of_four);
}

std::array<dReal, 4> quaternion(const Eigen::Isometry3d& pose) {
  const Eigen::Quaterniond q(pose.linear());
  return {q.w(), q.x(), q.y(), q.z()};
}

}  // namespace

/// One robot and a floor in an ODE world, under one physics.
class OdeRobot {
 public:
  OdeRobot(const RobotDescription& robot, const Physics& physics)
      : robot_(underPhysics(robot, physics)) {
    OdeLibrary::prepareThread();
    for (std::size_t leg = 0; leg < robot_.legs.size(); ++leg) {
      touch_counts_.push_back(touchCounts(physics, leg));
    }
    makeWorld(gravityOnFloor(physics));
    makeBodies();
    makeHinges();
  }

  ~OdeRobot() {
    for (const OdeShape& shape : base_shapes_) dGeomDestroy(shape.geom);
    for (const OdeShape& shape : leg_shapes_) dGeomDestroy(shape.geom);
    dGeomDestroy(floor_);
    dJointGroupDestroy(contacts_);
    dWorldDestroy(world_);
    // Left over from a failed step, its job list refuses to be freed: that memory is given up.
    if (!stepping_) dThreadingFreeImplementation(threading_);
  }

  OdeRobot(const OdeRobot&) = delete;
  OdeRobot& operator=(const OdeRobot&) = delete;

  std::size_t bodyCount() const { return bodies_.size(); }

  void read(std::size_t b, double* values) const {
    values = std::copy_n(dBodyGetPosition(bodies_[b]), 3, values);
    values = std::copy_n(dBodyGetQuaternion(bodies_[b]), 4, values);
    values = std::copy_n(dBodyGetLinearVel(bodies_[b]), 3, values);
    std::copy_n(dBodyGetAngularVel(bodies_[b]), 3, values);
  }

  // ODE's setter normalises the quaternion once more and changes its last bits; the body's own
  // memory is written instead. dBodySetPosition() then tells the shapes that the body has moved.
  void write(std::size_t b, const double* values) {
    std::copy_n(values + 3, 4, const_cast<dReal*>(dBodyGetQuaternion(bodies_[b])));
    dRfromQ(const_cast<dReal*>(dBodyGetRotation(bodies_[b])), values + 3);
    dBodySetPosition(bodies_[b], values[0], values[1], values[2]);
    dBodySetLinearVel(bodies_[b], values[7], values[8], values[9]);
    dBodySetAngularVel(bodies_[b], values[10], values[11], values[12]);
  }

  Eigen::Isometry3d worldFromBase() const {
    Eigen::Isometry3d world_from_base = Eigen::Isometry3d::Identity();
    world_from_base.linear() = rotation(dBodyGetRotation(bodies_[0]));
    world_from_base.translation() = vector(dBodyGetPosition(bodies_[0])) -
                                    world_from_base.linear() * robot_.base.center_of_mass_m;
    return world_from_base;
  }

  double angle_rad(std::size_t joint) const { return dJointGetHingeAngle(hinges_[joint]); }

  bool diverged() const {
    return std::any_of(bodies_.begin(), bodies_.end(), [](dBodyID body) {
      return isAbsurd(vector(dBodyGetPosition(body)), vector(dBodyGetLinearVel(body)),
                      vector(dBodyGetAngularVel(body)));
    });
  }

  // The position servo of RobotDescription::servo, as a velocity for the hinge's motor.
  void drive(const std::vector<double>& targets_rad) {
    for (std::size_t j = 0; j < hinges_.size(); ++j) {
      const double limit = joints_[j]->max_velocity_rad_per_s;
      const double wanted = robot_.servo.gain_per_s * (targets_rad[j] - angle_rad(j));
      const double velocity = std::abs(wanted) < robot_.servo.dead_zone_rad_per_s
                                  ? 0.0
                                  : std::clamp(wanted, -limit, limit);
      dJointSetHingeParam(hinges_[j], dParamVel, velocity);
    }
  }

  // Makes this step's contacts with the floor and tells what the present poses are. `unevenness`
  // sets their softness and slip apart by as much of their values, each one from all others.
  Verdict touch(double unevenness) {
    unevenness_ = unevenness;
    uneven_values_ = 0;
    const Eigen::Isometry3d world_from_base = worldFromBase();
    bool fell = !(world_from_base.translation().z() <= robot_.failure.max_base_height_m) ||
                !(world_from_base.linear()(2, 2) >= 0.0);
    for (const OdeShape& shape : base_shapes_) fell |= touchFloor(shape);
    for (const OdeShape& shape : leg_shapes_) touchFloor(shape);
    if (fell) return Verdict::kFell;
    return legsTouch() ? Verdict::kSelfCollided : Verdict::kWalked;
  }

  // False when dSolveLCP gave up: the bodies have then moved under some of their forces only.
  bool integrate(double step_s) {
    lcp_gave_up = false;
    stepping_ = true;  // and stays so when ODE throws
    if (!dWorldStep(world_, step_s)) throw OdeFailure();
    stepping_ = false;
    dJointGroupEmpty(contacts_);
    return !lcp_gave_up;
  }

 private:
  struct OdeShape {
    dGeomID geom;
    std::size_t leg;  // unused for the base's
    double radius_m;  // of the sphere around the shape's centre that holds it
  };

  void makeWorld(const Eigen::Vector3d& gravity_m_per_s2) {
    world_ = dWorldCreate();
    threading_ = dThreadingAllocateSelfThreadedImplementation();
    dWorldSetStepThreadingImplementation(world_, dThreadingImplementationGetFunctions(threading_),
                                         threading_);
    const Contact& contact = robot_.contact;
    dWorldSetGravity(world_, gravity_m_per_s2.x(), gravity_m_per_s2.y(), gravity_m_per_s2.z());
    dWorldSetERP(world_, contact.joint_erp);
    dWorldSetCFM(world_, contact.joint_cfm);
    dWorldSetContactMaxCorrectingVel(world_, contact.max_correcting_velocity_m_per_s);
    dWorldSetAutoDisableFlag(world_, 0);
    dWorldSetDamping(world_, 0.0, 0.0);
    contacts_ = dJointGroupCreate(0);
    floor_ = dCreatePlane(nullptr, 0.0, 0.0, 1.0, 0.0);
    surface_.mode =
        dContactApprox1 | dContactSlip1 | dContactSlip2 | dContactSoftERP | dContactSoftCFM;
    surface_.mu = contact.friction;
    surface_.slip1 = surface_.slip2 = contact.slip_per_n_s;
    surface_.soft_erp = contact.soft_erp;
    surface_.soft_cfm = contact.soft_cfm;
  }

  // All bodies at joint angles 0, where the hinges are made.
  void makeBodies() {
    zero_pose_ = baseFromBodies(robot_, std::vector<double>(robot_.jointCount(), 0.0));
    bodies_.push_back(makeBody(robot_.base, zero_pose_[0]));
    addShapes(robot_.base, bodies_[0], 0, base_shapes_);
    for (std::size_t leg = 0; leg < robot_.legs.size(); ++leg) {
      for (const Segment& segment : robot_.legs[leg].segments) {
        bodies_.push_back(makeBody(segment.body, zero_pose_[bodies_.size()]));
        addShapes(segment.body, bodies_.back(), leg, leg_shapes_);
      }
    }
  }

  // An ODE body's origin is its centre of mass; its axes are the link's.
  dBodyID makeBody(const Body& description, const Eigen::Isometry3d& world_from_body) {
    const Eigen::Matrix3d& inertia = description.inertia_kg_m2;
    dMass mass;
    dMassSetParameters(&mass, description.mass_kg, 0.0, 0.0, 0.0, inertia(0, 0), inertia(1, 1),
                       inertia(2, 2), inertia(0, 1), inertia(0, 2), inertia(1, 2));
    const dBodyID body = dBodyCreate(world_);
    dBodySetMass(body, &mass);
    const Eigen::Vector3d center = world_from_body * description.center_of_mass_m;
    dBodySetPosition(body, center.x(), center.y(), center.z());
    dBodySetQuaternion(body, quaternion(world_from_body).data());
    return body;
  }

  void addShapes(const Body& description, dBodyID body, std::size_t leg,
                 std::vector<OdeShape>& shapes) {
    for (const Shape& shape : description.shapes) {
      OdeShape made = makeShape(shape);
      made.leg = leg;
      const Eigen::Vector3d offset =
          shape.body_from_shape.translation() - description.center_of_mass_m;
      dGeomSetBody(made.geom, body);
      dGeomSetOffsetPosition(made.geom, offset.x(), offset.y(), offset.z());
      dGeomSetOffsetQuaternion(made.geom, quaternion(shape.body_from_shape).data());
      shapes.push_back(made);
    }
  }

  static OdeShape makeShape(const Shape& shape) {
    const Eigen::Vector3d& size = shape.size_m;
    switch (shape.kind) {
      case Shape::Kind::kBox:
        return {dCreateBox(nullptr, size.x(), size.y(), size.z()), 0, 0.5 * size.norm()};
      case Shape::Kind::kCapsule:
        return {dCreateCapsule(nullptr, shape.radius_m, shape.length_m), 0,
                0.5 * shape.length_m + shape.radius_m};
      case Shape::Kind::kSphere:
        break;
    }
    return {dCreateSphere(nullptr, shape.radius_m), 0, shape.radius_m};
  }

  void makeHinges() {
    joints_ = robot_.joints();
    for (const Leg& leg : robot_.legs) {
      std::size_t parent = 0;
      for (const Segment& segment : leg.segments) {
        const std::size_t child = hinges_.size() + 1;
        hinges_.push_back(makeHinge(segment.joint, parent, child));
        parent = child;
      }
    }
  }

  dJointID makeHinge(const Joint& joint, std::size_t parent, std::size_t child) {
    const dJointID hinge = dJointCreateHinge(world_, nullptr);
    // In this order ODE's angle is that of the child about the axis.
    dJointAttach(hinge, bodies_[child], bodies_[parent]);
    const Eigen::Vector3d anchor = zero_pose_[child].translation();
    const Eigen::Vector3d axis = zero_pose_[child].linear() * joint.axis;
    dJointSetHingeAnchor(hinge, anchor.x(), anchor.y(), anchor.z());
    dJointSetHingeAxis(hinge, axis.x(), axis.y(), axis.z());
    dJointSetHingeParam(hinge, dParamLoStop, joint.lower_rad);
    dJointSetHingeParam(hinge, dParamHiStop, joint.upper_rad);
    dJointSetHingeParam(hinge, dParamFMax, joint.max_torque_nm);
    return hinge;
  }

  bool touchFloor(const OdeShape& shape) {
    std::array<dContact, kMaxContactsPerPair> touching;
    const int count =
        dCollide(shape.geom, floor_, kMaxContactsPerPair, &touching[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
      touching[i].surface = nextSurface();
      dJointAttach(dJointCreateContact(world_, contacts_, &touching[i]), dGeomGetBody(shape.geom),
                   nullptr);
    }
    return count > 0;
  }

  dSurfaceParameters nextSurface() {
    dSurfaceParameters surface = surface_;
    for (dReal* value : {&surface.soft_cfm, &surface.slip1, &surface.slip2}) {
      *value *= 1.0 + unevenness_ * ++uneven_values_;
    }
    return surface;
  }

  bool legsTouch() const {
    dContactGeom touching;
    for (std::size_t a = 0; a < leg_shapes_.size(); ++a) {
      if (!touch_counts_[leg_shapes_[a].leg]) continue;
      for (std::size_t b = a + 1; b < leg_shapes_.size(); ++b) {
        if (leg_shapes_[a].leg == leg_shapes_[b].leg || !touch_counts_[leg_shapes_[b].leg] ||
            !mayTouch(leg_shapes_[a], leg_shapes_[b])) {
          continue;
        }
        if (dCollide(leg_shapes_[a].geom, leg_shapes_[b].geom, 1, &touching, sizeof(touching)) >
            0) {
          return true;
        }
      }
    }
    return false;
  }

  static bool mayTouch(const OdeShape& a, const OdeShape& b) {
    const Eigen::Vector3d apart =
        vector(dGeomGetPosition(a.geom)) - vector(dGeomGetPosition(b.geom));
    const double reach_m = a.radius_m + b.radius_m;
    return apart.squaredNorm() <= reach_m * reach_m;
  }

  RobotDescription robot_;
  std::vector<bool> touch_counts_;  // per leg
  std::vector<const Joint*> joints_;
  std::vector<Eigen::Isometry3d> zero_pose_;
  dWorldID world_ = nullptr;
  dThreadingImplementationID threading_ = nullptr;
  bool stepping_ = false;
  dJointGroupID contacts_ = nullptr;
  dGeomID floor_ = nullptr;
  dSurfaceParameters surface_{};
  double unevenness_ = 0.0;       // of this step's contacts
  int uneven_values_ = 0;         // handed out in this step
  std::vector<dBodyID> bodies_;   // base, then segments in joint order
  std::vector<dJointID> hinges_;  // in joint order
  std::vector<OdeShape> base_shapes_;
  std::vector<OdeShape> leg_shapes_;
};

OdeWorld::OdeWorld(const RobotDescription& robot, const Physics& physics, const WorldState* settled)
    : description_(robot), physics_(physics), held_(robot, physics) {
  checkPhysics(physics_);
  build();
  if (settled != nullptr) {
    settled_ = *settled;
  } else {
    settle();
    settled_ = footprintAtOrigin(worldFromBase(), state(), ode_->bodyCount());
  }
  restart();
}

OdeWorld::~OdeWorld() = default;

void OdeWorld::build() { ode_ = std::make_unique<OdeRobot>(description_, physics_); }

void OdeWorld::settle() {
  restore(standingState(description_));
  setTargets(description_.neutralPose());
  const int steps = static_cast<int>(std::lround(kSettlingTime_s / kSettlingStep_s));
  for (int i = 1; i <= steps; ++i) {
    const Verdict verdict = advance(kSettlingStep_s);
    if (verdict == Verdict::kWalked) continue;
    throwDoesNotStand(description_, verdict, i * kSettlingStep_s);
  }
}

WorldState OdeWorld::state() const {
  WorldState state;
  state.values.resize(ode_->bodyCount() * kStateValuesPerBody);
  for (std::size_t b = 0; b < ode_->bodyCount(); ++b) {
    ode_->read(b, &state.values[b * kStateValuesPerBody]);
  }
  state.values.insert(state.values.end(), targets_rad_.begin(), targets_rad_.end());
  return state;
}

void OdeWorld::restore(const WorldState& state) {
  const std::size_t of_bodies = ode_->bodyCount() * kStateValuesPerBody;
  const std::size_t expected = of_bodies + description_.jointCount();
  if (state.values.size() != expected) {
    throw std::invalid_argument("A state of robot '" + description_.name + "' in ODE has " +
                                std::to_string(expected) + " values, found " +
                                std::to_string(state.values.size()) +
                                "; restore only states of the same engine and robot.");
  }
  for (std::size_t b = 0; b < ode_->bodyCount(); ++b) {
    ode_->write(b, &state.values[b * kStateValuesPerBody]);
  }
  targets_rad_.assign(state.values.begin() + of_bodies, state.values.end());
  diverged_ = ode_->diverged();
}

void OdeWorld::setTargets(const std::vector<double>& targets_rad) {
  if (targets_rad.size() != description_.jointCount()) {
    throw std::invalid_argument("Robot '" + description_.name + "' has " +
                                std::to_string(description_.jointCount()) + " joints, found " +
                                std::to_string(targets_rad.size()) + " targets.");
  }
  targets_rad_ = targets_rad;
  held_.apply(targets_rad_);
}

Verdict OdeWorld::step() { return advance(physics_.step_s); }

Verdict OdeWorld::advance(double step_s) {
  if (diverged_) return Verdict::kDiverged;
  OdeLibrary::prepareThread();
  try {
    const Verdict verdict = solvedStep(step_s);
    diverged_ = ode_->diverged();
    return diverged_ ? Verdict::kDiverged : verdict;
  } catch (const OdeFailure&) {
    // What ODE leaves behind in the middle of a step is of no further use.
    build();
    diverged_ = true;
    return Verdict::kDiverged;
  }
}

Verdict OdeWorld::solvedStep(double step_s) {
  const WorldState before = state();
  double unevenness = 0.0;
  for (int tries = 0; tries < kMostTries; ++tries) {
    if (tries > 0) restore(before);
    ode_->drive(targets_rad_);
    const Verdict verdict = ode_->touch(unevenness);
    if (ode_->integrate(step_s)) return verdict;
    unevenness = tries == 0 ? kLeastUnevenness : 10.0 * unevenness;
  }
  throw OdeFailure();
}

Eigen::Isometry3d OdeWorld::worldFromBase() const { return ode_->worldFromBase(); }

void OdeWorld::jointAngles(std::vector<double>& angles_rad) const {
  angles_rad.resize(description_.jointCount());
  for (std::size_t j = 0; j < angles_rad.size(); ++j) angles_rad[j] = ode_->angle_rad(j);
}

}  // namespace hexapod
