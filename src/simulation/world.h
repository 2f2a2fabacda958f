#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <string>
#include <vector>

#include "gait/outcome.h"
#include "robot/dimensions.h"
#include "simulation/leg_state.h"

namespace hexapod {

/// What can differ from the nominal world: the step of the integrator, scales on the robot
/// description's own values, and what is wrong with the body. The reality gap, on purpose, and the
/// one language of perturbed learning, disturbed robots and what a robot believes of itself.
struct Physics {
  double step_s = 0.015;  ///< [s]; command period must be a multiple of it
  double gravity_m_per_s2 = kGravity_m_per_s2;
  double friction_scale = 1.0;              ///< of Contact::friction
  double mass_scale = 1.0;                  ///< of every mass and inertia
  double servo_gain_scale = 1.0;            ///< of Servo::gain_per_s
  double torque_scale = 1.0;                ///< of every joint's max_torque_nm
  double slope_x_rad = 0.0;                 ///< floor rises toward +x: gravity is tilted instead
  double slope_y_rad = 0.0;                 ///< floor rises toward +y
  double command_latency_s = 0.0;           ///< commands act this much later, to the nearest step
  std::vector<double> joint_torque_scales;  ///< one per joint, beside torque_scale; empty: all 1
  std::vector<LegState> legs;               ///< one per leg; empty: all intact
};

/// A copy of a world's full dynamic state; opaque, and valid for worlds of the same engine and
/// robot.
struct WorldState {
  std::vector<double> values;
};

/// One simulated robot on a plane: the only place that moves in time.
///
/// One world per thread; a world is used by one thread at a time, different worlds by different
/// threads at once. Bit-identical results for equal targets from equal states, whatever ran before
/// and whatever other threads do.
class World {
 public:
  virtual ~World() = default;

  virtual const RobotDescription& robot() const = 0;
  virtual const Physics& physics() const = 0;

  /// Puts the robot back to the settled stand: neutral pose, at rest, footprint at the origin.
  /// (Settled once, at construction, for about 1 s at a 1 ms step; then restored exactly.)
  virtual void restart() = 0;

  virtual WorldState state() const = 0;
  virtual void restore(const WorldState& state) = 0;

  /// Joint targets [rad] in joint order, held until the next call. Legs that hold an angle
  /// (LegState) keep theirs. Acts at once: who plays commands delays them by command_latency_s.
  virtual void setTargets(const std::vector<double>& targets_rad) = 0;

  /// Advances by physics().step_s. Returns kWalked while nothing failed; the failures of Outcome
  /// otherwise. A failed world goes on stepping (a robot that fell lies there), except diverged
  /// ones, which stay diverged until restart() or restore().
  virtual Verdict step() = 0;

  virtual Eigen::Isometry3d worldFromBase() const = 0;

  /// Joint angles [rad] in joint order; resizes to the joint count.
  virtual void jointAngles(std::vector<double>& angles_rad) const = 0;
};

/// Which implementation of World.
enum class Engine {
  kOde,     ///< ODE itself: the reference, for any robot
  kReduced  ///< the same equations in reduced coordinates, some thirty times as fast
};

/// The names of the engines: choices of the option `engine`.
const std::vector<std::string>& engineNames();

/// One of engineNames().
std::string toString(Engine engine);

/// The engine to use for a robot.
struct EngineChoice {
  Engine engine = Engine::kOde;
  std::string remark;  ///< a sentence for the user when it is not the one asked for; else empty
};

/// The engine named `name` (one of engineNames()), or ODE with a remark when that one does not
/// cover the robot. Throws std::invalid_argument for another name.
EngineChoice chooseEngine(const std::string& name, const RobotDescription& robot);

/// Builds a world. The description is copied in. Throws std::invalid_argument when a physics value
/// is out of range (naming it). With `settled`, of a world of the same engine and robot, that is
/// what restart() puts back: nothing is settled, and a body that cannot stand may be built.
std::unique_ptr<World> makeWorld(Engine engine, const RobotDescription& robot,
                                 const Physics& physics, const WorldState* settled = nullptr);

}  // namespace hexapod
