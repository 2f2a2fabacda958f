#pragma once

#include <memory>

#include "gait/behavior_options.h"
#include "simulation/world.h"
#include "transferability/trial_robot.h"

namespace hexapod {

/// A simulated robot in place of a real one: in ODE, whatever candidates are simulated with, and
/// with a body of its own. Every behaviour begins at the stand, so that a trial depends on its
/// genome alone.
class SimulatedTrialRobot : public TrialRobot {
 public:
  /// Throws std::invalid_argument when a value of the body is out of range, or the behaviour does
  /// not fit the robot.
  SimulatedTrialRobot(const RobotDescription& robot, const Physics& body,
                      const BehaviorOptions& behavior);

  Result play(const Genome& genome) override;

 private:
  std::unique_ptr<World> world_;
  BehaviorOptions behavior_;
};

}  // namespace hexapod
