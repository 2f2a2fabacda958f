#include "evaluation/robust_options.h"

#include <numeric>

#include "common/stratified.h"
#include "simulation/rollout.h"

namespace hexapod {
namespace {

// Other generators get the seed as it is.
constexpr std::uint64_t kPurposeOfWorlds = 0x726f62757374;

}  // namespace

std::vector<Option> declareOptions(RobustnessOptions& options) {
  return {
      option("perturbed_physics", options.perturbed_physics,
             "Runs under other physics (step, friction, mass, servo) for every candidate that "
             "would enter the archive; 0: none.",
             0, 100),
      option("perturbed_start_states", options.start_states,
             "Runs from states after other behaviours for every candidate that would enter the "
             "archive; 0: none.",
             0, 100),
      option("screening_runs", options.screening_runs,
             "So many of these runs come first, and the others only for candidates that would "
             "enter the archive even by what those show; 0: all at once.",
             0, 200),
      option("quality", options.quality,
             "What candidates compete with: the orientation error, to which the spread over these "
             "runs adds, or the steadiness, which is that spread alone: for ends of any heading "
             "(heading_m_per_rad).",
             {"orientation_error", "steadiness"}),
      option("spread_weight_rad_per_m", options.spread_weight_rad_per_m, "rad/m",
             "What a metre of spread of the end positions over these runs counts in the "
             "orientation error that candidates compete with.",
             0.0, 1000.0),
      option(
          "first_look_handicap_rad", options.first_look_handicap_rad, "rad",
          "Added to the orientation error of a candidate that was tried under nominal conditions "
          "only: the larger, the fewer are tried under the others.",
          0.0, 1.0),
      option("friction_variation", options.friction_variation, "",
             "Friction under perturbed physics: 1 -+ this times the nominal.", 0.0, 0.9),
      option("mass_variation", options.mass_variation, "",
             "Masses under perturbed physics: 1 -+ this times the nominal.", 0.0, 0.9),
      option("servo_gain_variation", options.servo_gain_variation, "",
             "Servo gains under perturbed physics: 1 -+ this times the nominal.", 0.0, 0.9),
      option("torque_variation", options.torque_variation, "",
             "Torques under perturbed physics: 1 -+ this times the nominal.", 0.0, 0.9),
      option("slope_variation_rad", options.slope_variation_rad, "rad",
             "Slopes of the floor under perturbed physics, along x and y, either way.", 0.0, 0.3),
  };
}

std::vector<Physics> perturbedPhysics(const RobustnessOptions& options, const Physics& nominal,
                                      double command_period_s, std::uint64_t seed) {
  Random random(seed ^ kPurposeOfWorlds);
  const auto count = static_cast<std::size_t>(options.perturbed_physics);
  const auto factors = [&](double variation) {
    return stratified(count, 1.0 - variation, 1.0 + variation, random);
  };
  const auto friction = factors(options.friction_variation);
  const auto mass = factors(options.mass_variation);
  const auto gain = factors(options.servo_gain_variation);
  const auto torque = factors(options.torque_variation);
  const double slope_rad = options.slope_variation_rad;
  const auto slope_x_rad = stratified(count, -slope_rad, slope_rad, random);
  const auto slope_y_rad = stratified(count, -slope_rad, slope_rad, random);
  const std::size_t steps = stepsPerCommand(command_period_s, nominal.step_s);
  std::vector<Physics> all(count, nominal);
  for (std::size_t i = 0; i < count; ++i) {
    if (i % 3 != 0) all[i].step_s = command_period_s / static_cast<double>(steps + i % 3);
    all[i].friction_scale *= friction[i];
    all[i].mass_scale *= mass[i];
    all[i].servo_gain_scale *= gain[i];
    all[i].torque_scale *= torque[i];
    all[i].slope_x_rad += slope_x_rad[i];
    all[i].slope_y_rad += slope_y_rad[i];
  }
  return all;
}

}  // namespace hexapod
