#include "simulation/rollout.h"

#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "common/text.h"
#include "geometry/pose2.h"
#include "simulation/physics.h"

namespace hexapod {
namespace {

Outcome failed(Verdict verdict) {
  Outcome outcome;
  outcome.verdict = verdict;
  return outcome;
}

}  // namespace

std::size_t stepsPerCommand(double command_period_s, double step_s) {
  const double steps = command_period_s / step_s;
  const double whole = std::round(steps);
  if (whole >= 1.0 && std::abs(steps - whole) < 1e-6) return static_cast<std::size_t>(whole);
  throw std::invalid_argument("The command period of " + numberText(command_period_s) +
                              " s is not a multiple of the simulation step of " +
                              numberText(step_s) +
                              " s; choose a step_s that divides command_period_s.");
}

Outcome play(World& world, const Behavior& behavior, double command_period_s) {
  const std::size_t steps = stepsPerCommand(command_period_s, world.physics().step_s);
  const Pose2 world_from_start = footprint(world.worldFromBase());
  const std::size_t latency = latencySteps(world.physics());
  for (std::size_t i = 0; i < behavior.commandCount() * steps; ++i) {
    if (i >= latency && (i - latency) % steps == 0) {
      world.setTargets(behavior.command((i - latency) / steps));
    }
    const Verdict verdict = world.step();
    if (verdict != Verdict::kWalked) return failed(verdict);
  }
  return walkedTo(inverse(world_from_start) * footprint(world.worldFromBase()));
}

}  // namespace hexapod
