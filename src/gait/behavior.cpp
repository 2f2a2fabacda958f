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

Gait gaitOf(const RobotDescription& robot, const Genome& genome, const BehaviorOptions& options) {
  const auto levels = static_cast<std::size_t>(options.gene_levels);
  return {robot, canonical(genome, levels), levels};
}

}  // namespace

Behavior::Behavior(const RobotDescription& robot, const Genome& genome,
                   const BehaviorOptions& options)
    : period_s_(options.command_period_s) {
  checkReturnIsSlowEnough(robot, options);
  const Gait gait = gaitOf(robot, genome, options);
  play(robot, options, [&](std::size_t k, Angles& angles) {
    gait.angles(static_cast<double>(k) * options.command_period_s, angles);
  });
}

template <typename GaitAngles>
void Behavior::play(const RobotDescription& robot, const BehaviorOptions& options,
                    const GaitAngles& gait) {
  const BehaviorParts parts = behaviorParts(options);
  const std::vector<const Joint*> joints = robot.joints();
  const Angles neutral = robot.neutralPose();
  commands_.reserve(parts.total());
  Angles previous = neutral;
  for (std::size_t k = 0; k < parts.gait; ++k) {
    Angles angles;
    gait(k, angles);
    for (std::size_t j = 0; j < joints.size(); ++j) {
      angles[j] = reachable(*joints[j], angles[j], previous[j], options);
    }
    commands_.push_back(angles);
    previous = std::move(angles);
  }
  for (std::size_t k = 1; k < parts.way_back; ++k) {
    commands_.push_back(between(previous, neutral, static_cast<double>(k) / parts.way_back));
  }
  // The ramp arrives exactly.
  commands_.resize(parts.total(), neutral);
}

BehaviorMaker::BehaviorMaker(const RobotDescription& robot, const BehaviorOptions& options)
    : robot_(&robot), options_(options) {
  checkReturnIsSlowEnough(robot, options);
  for (std::size_t k = 0; k < behaviorParts(options).gait; ++k) {
    signals_.push_back(gaitSignals(static_cast<double>(k) * options.command_period_s,
                                   static_cast<std::size_t>(options.gene_levels)));
  }
}

Behavior BehaviorMaker::make(const Genome& genome) const {
  const Gait gait = gaitOf(*robot_, genome, options_);
  Behavior behavior(options_.command_period_s);
  behavior.play(*robot_, options_,
                [&](std::size_t k, Angles& angles) { gait.angles(signals_[k], angles); });
  return behavior;
}

}  // namespace hexapod
