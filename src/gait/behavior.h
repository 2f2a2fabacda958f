#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "gait/gait.h"

namespace hexapod_repertoire {

/// When the end pose of a behaviour is read.
enum class EndPose {
  kAtRest,    ///< after the return to the neutral pose, at rest: what a robot that chains them needs
  kAfterGait  ///< right after the gait, as in the paper
};

/// How a gait becomes a behaviour.
struct BehaviorOptions {
  double gait_duration_s = 3.0;     ///< > 0; multiple of command_period_s
  double command_period_s = 0.030;  ///< > 0
  double return_duration_s = 0.6;   ///< ramp back to neutral, >= 0
  double rest_duration_s = 0.3;     ///< neutral pose held, >= 0
  EndPose end_pose = EndPose::kAtRest;
  /// Commands never move faster than the joint's velocity limit. Off for the paper's own reading,
  /// which sends eq. 3 as it is.
  bool limit_velocity = true;
};

/// What the learner evaluates and the executor plays, command by command, the same in both:
/// neutral pose -> gait -> back to the neutral pose, at rest. ("A behaviour", see README.)
///
/// A behaviour is a fixed sequence of commandCount() joint commands, one per command period; command
/// k is sent at k * command_period_s and holds until the next. All are within the joint position
/// limits, and with limit_velocity two successive ones (the first against the neutral pose) differ
/// by at most velocity limit * period. With EndPose::kAfterGait the sequence stops after the gait.
/// Immutable once built; const functions may be called from any thread. The description must outlive it only during construction.
class Behavior {
 public:
  /// Throws std::invalid_argument when genome or options do not fit.
  Behavior(const RobotDescription& robot, const Genome& genome, const BehaviorOptions& options);

  std::size_t commandCount() const { return commands_.size(); }
  double duration_s() const { return commandCount() * period_s_; }

  /// Joint targets [rad] in joint order of command k < commandCount().
  const std::vector<double>& command(std::size_t k) const { return commands_[k]; }

 private:
  double period_s_;
  std::vector<std::vector<double>> commands_;
};

}  // namespace hexapod_repertoire
