#pragma once

#include <memory>
#include <string>
#include <vector>

#include "simulation/physics.h"
#include "simulation/world.h"

namespace hexapod {

class OdeRobot;

/// The reference World: Open Dynamics Engine, dWorldStep (the exact solver), one hinge with its own
/// motor per joint, feet and legs against a plane.
///
/// The frame of the floor has its origin where the settled robot's footprint is; after restart()
/// the footprint is at (0, 0) with heading 0 to the rounding of the shift (1e-15 at most). A step
/// first looks at the poses it starts from: a base shape on the floor, the base's origin above the
/// allowed height or the base upside down is kFell, two legs touching is kSelfCollided (legs pass
/// through each other and through the base all the same); then it drives the servos, with each
/// hinge's angle as it is, and integrates. Every shape that touches the floor gets up to 10
/// contacts.
///
/// Bit-identical results whatever ran before and in whatever thread: dWorldStep draws no random
/// numbers and keeps nothing between steps but positions, quaternions and velocities, which state()
/// holds to the last bit; rotation matrices follow from the quaternions. ODE's thread-local data is
/// set up for each thread that steps, and each world has a threading implementation of its own (the
/// default one is shared by all worlds and aborts when two threads step). ODE's messages are
/// silenced for the whole process, its errors become kDiverged.
///
/// dSolveLCP gives up when rows reach their bounds at exactly the same time, as those of a
/// symmetric robot do, and leaves the remaining forces out. Such a step is taken back and repeated
/// with contacts whose softness and slip differ by 1e-9 of their values, or more if need be
/// (doc/reduced_dynamics.md); kDiverged when even 1e-6 does not help.
class OdeWorld : public World {
 public:
  /// Throws std::invalid_argument (physics out of range, a robot without shapes) or
  /// std::runtime_error (the robot does not stand in its neutral pose). With `settled` nothing is
  /// settled: that is what restart() puts back.
  OdeWorld(const RobotDescription& robot, const Physics& physics,
           const WorldState* settled = nullptr);
  ~OdeWorld() override;

  const RobotDescription& robot() const override { return description_; }
  const Physics& physics() const override { return physics_; }

  void restart() override { restore(settled_); }

  /// Per body (base, then segments in joint order) the position of its centre of mass [m],
  /// quaternion (w, x, y, z), velocity [m/s] and rate [rad/s]; then the joint targets [rad].
  WorldState state() const override;

  /// Throws std::invalid_argument when the number of values does not fit the robot.
  void restore(const WorldState& state) override;

  /// Throws std::invalid_argument when the number of targets is not the number of joints.
  void setTargets(const std::vector<double>& targets_rad) override;

  Verdict step() override;
  Eigen::Isometry3d worldFromBase() const override;
  void jointAngles(std::vector<double>& angles_rad) const override;

 private:
  void build();
  void settle();
  Verdict advance(double step_s);
  Verdict solvedStep(double step_s);

  RobotDescription description_;
  Physics physics_;
  HeldJoints held_;
  std::unique_ptr<OdeRobot> ode_;
  std::vector<double> targets_rad_;
  bool diverged_ = false;
  WorldState settled_;
};

}  // namespace hexapod
