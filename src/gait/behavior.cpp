#include "gait/behavior.h"

#include <algorithm>

#include "gait/gait.h"

namespace hexapod {
namespace {

using Angles = std::vector<double>;

// Keeps a target within the joint's position limits and, when limited, within one period's reach.
double reachable(const Joint& joint, double target_rad, double previous_rad,
                 const BehaviorOptions& options) {
  double reached_rad = target_rad;
  if (options.limit_velocity) {
    const double step_rad = joint.max_velocity_rad_per_s * options.command_period_s;
    reached_rad = std::clamp(target_rad, previous_rad - step_rad, previous_rad + step_rad);
  }
  return std::clamp(reached_rad, joint.lower_rad, joint.upper_rad);
}

Angles between(const Angles& from, const Angles& to, double fraction) {
  Angles angles(from.size());
  for (std::size_t j = 0; j < from.size(); ++j) {
    angles[j] = from[j] + fraction * (to[j] - from[j]);
  }
  return angles;
}

}  // namespace

Behavior::Behavior(const RobotDescription& robot, const Genome& genome,
                   const BehaviorOptions& options)
    : Behavior(BehaviorMaker(robot, options).make(genome)) {}

BehaviorMaker::BehaviorMaker(const RobotDescription& robot, const BehaviorOptions& options)
    : robot_(&robot),
      options_(options),
      joints_(robot.joints()),
      neutral_rad_(robot.neutralPose()) {
  const std::size_t commands = behaviorParts(options).gait;
  checkReturnIsSlowEnough(robot, options);
  for (std::size_t k = 0; k < commands; ++k) {
    signals_.push_back(gaitSignals(static_cast<double>(k) * options.command_period_s));
  }
}

Behavior BehaviorMaker::make(const Genome& genome) const {
  const BehaviorParts parts = behaviorParts(options_);
  const Gait gait(*robot_, genome);
  Behavior::Commands commands;
  commands.reserve(parts.total());

  Angles previous = neutral_rad_;
  for (const GaitSignals& signals : signals_) {
    Angles angles;
    gait.angles(signals, angles);
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      angles[j] = reachable(*joints_[j], angles[j], previous[j], options_);
    }
    commands.push_back(angles);
    previous = std::move(angles);
  }
  for (std::size_t k = 1; k < parts.way_back; ++k) {
    commands.push_back(between(previous, neutral_rad_, static_cast<double>(k) / parts.way_back));
  }
  // The ramp arrives exactly.
  commands.resize(parts.total(), neutral_rad_);
  return {options_.command_period_s, std::move(commands)};
}

}  // namespace hexapod
