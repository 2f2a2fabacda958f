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
    : period_s_(options.command_period_s) {
  const BehaviorParts parts = behaviorParts(options);
  checkReturnIsSlowEnough(robot, options);
  const Gait gait(robot, genome);
  const std::vector<const Joint*> joints = robot.joints();
  const Angles neutral = robot.neutralPose();
  commands_.reserve(parts.total());

  Angles previous = neutral;
  for (std::size_t k = 0; k < parts.gait; ++k) {
    Angles angles;
    gait.angles(static_cast<double>(k) * period_s_, angles);
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

}  // namespace hexapod
