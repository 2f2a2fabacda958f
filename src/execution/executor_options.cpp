#include "execution/executor_options.h"

namespace hexapod {

std::vector<Option> declareOptions(ExecutorOptions& options) {
  return {
      option("feedback_timeout_s", options.feedback_timeout_s, "s",
             "Longest silence of joint_states before the executor faults; 0: open loop.", 0.0,
             60.0),
      option("start_tolerance_rad", options.start_tolerance_rad, "rad",
             "Distance of a joint from its neutral angle up to which arming is no far start.", 0.0,
             6.3),
      option("far_start", options.far_start,
             "Arming further off: ramp slowly to the neutral pose, or refuse.",
             {FarStart::kRamp, FarStart::kRefuse}),
      option("ramp_time_s", options.ramp_time_s, "s",
             "Shortest ramp to or from the neutral pose; longer where a joint's velocity limit "
             "asks for it.",
             0.1, 60.0),
      option("hold_time_s", options.hold_time_s, "s",
             "How long the last command is held when a behaviour is broken off.", 0.0, 10.0),
      option("max_tracking_error_rad", options.max_tracking_error_rad, "rad",
             "Distance between command and measured angle above which a joint does not follow; 0: "
             "not watched.",
             0.0, 6.3),
      option("tracking_timeout_s", options.tracking_timeout_s, "s",
             "How long a joint may be that far off before the executor faults; time within the "
             "tolerance counts against it, since gaits pass through where a stuck joint is.",
             0.0, 60.0),
      option("max_dead_legs", options.max_dead_legs,
             "Legs that need not follow or be read because body_belief tells that they are dead, "
             "or may still tell so; 0: every leg that does not follow is a fault at once.",
             0, 64),
      option("dead_legs", options.dead_legs,
             "Legs that are not there or out of order, by name with commas between them: their "
             "joints need neither be read nor follow, from the first arming on."),
      option("belief_patience_s", options.belief_patience_s, "s",
             "While body_belief comes, a leg that does not follow is waited with until a whole "
             "behaviour shows what is wrong with it, and so much longer; believed dead by then, "
             "the walk goes on, else the executor faults.",
             0.0, 60.0),
      option("sit_signal", options.sit_signal, "",
             "Second control signal (gamma of eq. 3) of every leg in the sitting pose.", -1.0, 1.0),
      option("e_stop_timeout_s", options.e_stop_timeout_s, "s",
             "Longest silence of e_stop: a publisher that falls silent stops the robot, and there "
             "is no arming without one; 0: e_stop need not be published.",
             0.0, 60.0),
      option("hold_on_stop", options.hold_on_stop,
             "After an emergency stop or ~stop send one last command, the measured pose (open "
             "loop: the last command); false: nothing at all."),
      option("max_acceleration_rad_per_s2", options.gate.max_acceleration_rad_per_s2, "rad/s^2",
             "Acceleration limit of every joint's commands; gaits are smoothed by it. 0: off.", 0.0,
             1e5),
      option("soft_limit_margin_rad", options.gate.soft_limit_margin_rad, "rad",
             "Distance that commands keep from the joints' position limits.", 0.0, 3.0),
  };
}

}  // namespace hexapod
