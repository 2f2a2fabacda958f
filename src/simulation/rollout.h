#pragma once

#include <cstddef>

#include "gait/behavior.h"
#include "gait/outcome.h"
#include "simulation/world.h"

namespace hexapod {

/// Plays one behaviour from the world's present state and returns its end pose relative to the
/// footprint it started from. Commands act command_latency_s late; what comes after the end never
/// acts. Stops at the first failure; the world is then left as it is.
/// Throws std::invalid_argument when the command period is not a multiple of the world's step.
Outcome play(World& world, const Behavior& behavior, double command_period_s);

/// How many steps a command holds. Throws std::invalid_argument when that is no whole number.
std::size_t stepsPerCommand(double command_period_s, double step_s);

}  // namespace hexapod
