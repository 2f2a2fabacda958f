#include "transferability/simulated_trial_robot.h"

#include "gait/behavior.h"
#include "simulation/rollout.h"

namespace hexapod {

SimulatedTrialRobot::SimulatedTrialRobot(const RobotDescription& robot, const Physics& body,
                                         const BehaviorOptions& behavior)
    : world_(makeWorld(Engine::kOde, robot, body)), behavior_(behavior) {}

TrialRobot::Result SimulatedTrialRobot::play(const Genome& genome) {
  world_->restart();
  const Outcome outcome = hexapod::play(*world_, Behavior(world_->robot(), genome, behavior_),
                                        behavior_.command_period_s);
  if (!outcome.walked()) return {true, std::nullopt, ""};
  return {true, outcome.end_pose, ""};
}

}  // namespace hexapod
