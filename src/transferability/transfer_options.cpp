#include "transferability/transfer_options.h"

namespace hexapod {

std::vector<Option> declareOptions(TransferOptions& options) {
  return {
      option("transferability", options.transferability,
             "Try some entries on the robot while learning, and prefer controllers that do there "
             "what they do in simulation; entries are expected where the robot would take them."),
      option("transferability_trials", options.trials, "Behaviours tried on the robot, in all.", 1,
             100000),
      option("transferability_period", options.trial_period,
             "Generations from one series of trials to the next.", 1, 1000000),
      option("transferability_series", options.trials_at_once,
             "Trials of a series, one after another.", 1, 100000),
      option("disparity_weight_rad_per_m", options.disparity_weight_rad_per_m, "rad/m",
             "What a metre between the robot and simulation, as far as is known, counts in the "
             "orientation error that candidates compete with.",
             0.0, 1000.0),
      option("robot_body", options.robot_body,
             "Trials are made with a simulated robot that has this body, in ODE, as in 'friction: "
             "0.6, gain: 0.7' (see body). Empty: with the robot of the running session."),
  };
}

}  // namespace hexapod
