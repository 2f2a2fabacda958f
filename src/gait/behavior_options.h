#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "common/options.h"
#include "gait/genome.h"
#include "robot/robot_description.h"

namespace hexapod {

/// When the end pose of a behaviour is read: the choices of the option end_pose.
struct EndPose {
  /// After the return to the neutral pose, at rest: what a robot that chains behaviours needs.
  static constexpr const char* kAtRest = "at_rest";
  /// Right after the gait, as in the paper.
  static constexpr const char* kAfterGait = "after_gait";
};

/// How a gait becomes a behaviour. All durations are whole multiples of the command period.
struct BehaviorOptions {
  double gait_duration_s = 3.0;             ///< eq. 3 is played, > 0
  double command_period_s = 0.030;          ///< > 0
  double return_duration_s = 0.6;           ///< straight ramp back to the neutral pose, >= 0
  double rest_duration_s = 0.3;             ///< neutral pose held, >= 0
  std::string end_pose = EndPose::kAtRest;  ///< one of EndPose
  /// Commands never move faster than the joint's velocity limit. Off for the paper's own reading,
  /// which sends eq. 3 as it is.
  bool limit_velocity = true;
  /// Of a genome's genes, see requireGeneLevels().
  std::int64_t gene_levels = kGeneLevels;
};

/// Commands of each part of a behaviour, one per command period.
struct BehaviorParts {
  std::size_t gait = 0;
  std::size_t way_back = 0;  ///< 0 with EndPose::kAfterGait
  std::size_t rest = 0;      ///< 0 with EndPose::kAfterGait

  std::size_t total() const { return gait + way_back + rest; }
};

/// The options under their names, bound to `options`, which must outlive them.
std::vector<Option> declareOptions(BehaviorOptions& options);

/// `defaults` with what a repertoire keeps of the options it was learned with, as texts by name;
/// others among them are left alone. Throws std::invalid_argument when one is out of range.
BehaviorOptions behaviorOptionsOf(const std::map<std::string, std::string>& kept,
                                  BehaviorOptions defaults);

/// Those of them that whoever plays a repertoire takes from it: how long, how often, of which
/// genes. The others are the learner's alone.
std::vector<Option> declarePlayingOptions(BehaviorOptions& options);

/// The parts the options ask for. Throws std::invalid_argument with a sentence naming the option,
/// its value and what is allowed: not finite or out of range, no multiple of the command period, an
/// unknown end_pose, an end at rest without any time to get there, gene_levels that make no gait.
BehaviorParts behaviorParts(const BehaviorOptions& options);

/// Throws std::invalid_argument naming return_duration_s and the joint when, with limit_velocity,
/// some genome's return to the neutral pose would exceed the joint's velocity limit.
void checkReturnIsSlowEnough(const RobotDescription& robot, const BehaviorOptions& options);

}  // namespace hexapod
