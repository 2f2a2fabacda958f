#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "simulation/physics.h"
#include "simulation/world.h"

namespace hexapod {

class BatchRollout;
namespace reduced {
struct ReducedModel;
class Stepper;
}  // namespace reduced

/// The fast World: the equations of ODE's dWorldStep in the robot's reduced coordinates
/// (doc/reduced_dynamics.md), for robots that coversRobot() tells.
///
/// Same parameters, order of updates, verdicts and state as OdeWorld: end poses of a behaviour
/// agree to about a nanometre, and a state of one may be restored in the other. What differs:
/// hinges and motors are rigid where ODE has them compliant by joint_cfm; a base lying on the floor
/// rests on all its corners, ODE's on at most four. Works without memory between steps, so results
/// depend on state and targets alone; const functions may be called from any thread.
class ReducedWorld final : public World {
 public:
  /// Throws std::invalid_argument (physics out of range, a robot that is not covered) or
  /// std::runtime_error (the robot does not stand in its neutral pose). With `settled` nothing is
  /// settled: that is what restart() puts back.
  ReducedWorld(const RobotDescription& robot, const Physics& physics,
               const WorldState* settled = nullptr);
  ~ReducedWorld() override;

  const RobotDescription& robot() const override { return description_; }
  const Physics& physics() const override { return physics_; }

  void restart() override { restore(settled_); }

  /// As OdeWorld::state().
  WorldState state() const override;

  /// Throws std::invalid_argument when the number of values does not fit the robot.
  void restore(const WorldState& state) override;

  /// Throws std::invalid_argument when the number of targets is not the number of joints.
  void setTargets(const std::vector<double>& targets_rad) override;

  Verdict step() override;
  Eigen::Isometry3d worldFromBase() const override;
  void jointAngles(std::vector<double>& angles_rad) const override;

  /// Plays many behaviours at once for the same robot and physics; independent of this world's
  /// state, made when first asked for, lives as long as the world.
  BatchRollout& batch();

 private:
  void settle();
  std::size_t valueCount() const;

  RobotDescription description_;
  Physics physics_;
  HeldJoints held_;
  std::unique_ptr<const reduced::ReducedModel> model_;
  std::unique_ptr<reduced::Stepper> stepper_;
  bool diverged_ = false;
  WorldState settled_;
  std::unique_ptr<BatchRollout> batch_;
};

/// True when ReducedWorld can simulate this robot; otherwise `reason` becomes a sentence that says
/// why not and to use ODE.
bool coversRobot(const RobotDescription& robot, std::string& reason);

}  // namespace hexapod
