#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/options.h"
#include "simulation/world.h"

namespace hexapod {

/// How candidates are tried under other conditions than the nominal ones; off by default.
struct RobustnessOptions {
  std::int64_t perturbed_physics = 0;  ///< runs with other physics, from the stand, 0 .. 100
  std::int64_t start_states = 0;       ///< runs after other behaviours, nominal physics, 0 .. 100
  /// Of these runs so many are for the second look, the others for the third, 0 .. 200; 0: all are
  /// for the second.
  std::int64_t screening_runs = 0;
  /// What candidates compete with: "orientation_error", its mean over all runs plus what their
  /// spread counts, or "steadiness", the spread alone.
  std::string quality = "orientation_error";
  /// What a metre of spread counts as orientation error [rad/m].
  double spread_weight_rad_per_m = 4.0;
  /// Added to the orientation error of a first look, for what perturbations will add at least
  /// [rad].
  double first_look_handicap_rad = 0.0;
  // How far the perturbed physics reach: factors are drawn from 1 -+ variation.
  double friction_variation = 0.25;
  double mass_variation = 0.10;
  double servo_gain_variation = 0.25;
  double torque_variation = 0.10;
  double slope_variation_rad = 0.0;  ///< slopes along x and along y, either way

  /// Runs beside the nominal one.
  std::int64_t runs() const { return perturbed_physics + start_states; }
  bool isOn() const { return runs() > 0; }
  bool steadinessAlone() const { return quality == "steadiness"; }
};

/// The options under their names, bound to `options`, which must outlive them.
std::vector<Option> declareOptions(RobustnessOptions& options);

/// The perturbed physics of a seed, one per run. Steps go in turn through the nominal one and the
/// next two smaller ones that divide the command period; of every other quantity each run gets its
/// own one of equal parts of the range (a Latin hypercube), so that few runs cover all of it.
std::vector<Physics> perturbedPhysics(const RobustnessOptions& options, const Physics& nominal,
                                      double command_period_s, std::uint64_t seed);

}  // namespace hexapod
