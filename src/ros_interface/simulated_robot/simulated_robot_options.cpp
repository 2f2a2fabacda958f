#include "ros_interface/simulated_robot/simulated_robot_options.h"

#include <stdexcept>

namespace hexapod {

std::vector<Option> declareOptions(SimulatedRobotOptions& options) {
  Disturbance& disturbance = options.disturbance;
  Physics& physics = disturbance.physics;
  return {
      option("robot_config", options.robot_config,
             "Path of the robot's YAML (legs, gait, servo, contact); its URDF is the parameter "
             "robot_description."),
      option("engine", options.engine, "Simulation engine, as in learning.", engineNames()),
      option("real_time_factor", options.real_time_factor, "",
             "Speed of simulated time; other than 1 only with publish_clock. 0: as fast as it can.",
             0.0, 100.0),
      option("publish_clock", options.publish_clock,
             "Publish the simulated time on /clock; set /use_sim_time with it."),
      option("command_latency_s", options.command_latency_s, "s",
             "A command acts this long after its stamp, which hides the jitter of its way.", 0.0,
             1.0),
      option("realtime", options.realtime,
             "Ask for a real-time priority, and go on without: a robot does not wait for other "
             "programs. At real_time_factor 1 only."),
      option("odom_frame", options.frames.odom_frame, "Frame in which the robot tells its pose."),
      option("base_frame", options.frames.base_frame, "The robot's footprint in tf."),
      option("tf_prefix", options.frames.tf_prefix,
             "In front of the base link's name in tf, with a slash, as robot_state_publisher has "
             "it; empty: nothing."),
      option("step_s", physics.step_s, "s", "Step of the integrator.", 1e-4, 0.1),
      option("gravity_m_per_s2", physics.gravity_m_per_s2, "m/s^2", "Gravity.", 0.0, 100.0),
      option("friction_scale", physics.friction_scale, "", "Times the description's friction.", 0.0,
             100.0),
      option("mass_scale", physics.mass_scale, "", "Times every mass and inertia.", 0.01, 100.0),
      option("servo_gain_scale", physics.servo_gain_scale, "", "Times the servos' gain.", 0.0,
             100.0),
      option("torque_scale", physics.torque_scale, "", "Times every joint's torque.", 0.0, 100.0),
      option("slope_x_rad", physics.slope_x_rad, "rad", "The floor rises toward +x.", -1.0, 1.0),
      option("slope_y_rad", physics.slope_y_rad, "rad", "The floor rises toward +y.", -1.0, 1.0),
      option("body", options.body,
             "What is otherwise about the body from the start: 'left_middle: limp, friction: 0.7'; "
             "legs are locked, lifted, limp or missing; by degrees friction, mass, gain, torque, "
             "slope_x, slope_y, latency."),
      option("latency_s", disturbance.latency_s, "s",
             "Commands act so much later than command_latency_s lets them.", 0.0, 1.0),
      option("dropped_share", disturbance.dropped_share, "", "Share of the commands that is lost.",
             0.0, 1.0),
      option("feedback_noise_rad", disturbance.feedback_noise_rad, "rad",
             "Standard deviation of the noise on reported joint angles.", 0.0, 1.0),
      option("dead_band_rad", disturbance.dead_band_rad, "rad",
             "A servo does not move for a command nearer to where it is than this.", 0.0, 1.0),
  };
}

void checkTime(const SimulatedRobotOptions& options, bool use_sim_time) {
  if (options.real_time_factor != 1.0 && !options.publish_clock) {
    throw std::invalid_argument(
        "~real_time_factor other than 1 needs ~publish_clock and /use_sim_time, so that all nodes "
        "follow the simulated time.");
  }
  if (options.publish_clock == use_sim_time) return;
  throw std::invalid_argument(
      options.publish_clock
          ? "~publish_clock is true but /use_sim_time is not; set both, so that all nodes follow "
            "the simulated time."
          : "/use_sim_time is true but ~publish_clock is not; set both, or neither.");
}

}  // namespace hexapod
