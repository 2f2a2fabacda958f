#pragma once

#include <cstddef>
#include <vector>

#include "gait/behavior_options.h"
#include "gait/gait.h"
#include "gait/genome.h"
#include "robot/robot_description.h"

namespace hexapod {

/// What the learner evaluates and the executor plays, command by command, the same in both:
/// neutral pose -> gait -> back to the neutral pose, at rest. ("A behaviour": doc/house.md.)
/// Genomes of the same gait are the same behaviour: the canonical() one is played.
///
/// A behaviour is a fixed sequence of commandCount() joint commands, one per command period;
/// command k is sent at k * command_period_s and holds until the next. It is the gait at that time,
/// then a straight ramp from the last gait command to the neutral pose, then the neutral pose. All
/// commands are within the joint position limits, and with limit_velocity two successive ones (the
/// first against the neutral pose) differ by at most velocity limit * period. Every behaviour of
/// the same options has the same number of commands. With EndPose::kAfterGait it stops after the
/// gait. Immutable once built; const functions may be called from any thread. The description is
/// used only during construction.
class Behavior {
 public:
  using Commands = std::vector<std::vector<double>>;

  /// Throws std::invalid_argument when genome or options do not fit the robot or each other, with a
  /// sentence naming the gene or the option.
  Behavior(const RobotDescription& robot, const Genome& genome, const BehaviorOptions& options);

  std::size_t commandCount() const { return commands_.size(); }
  double duration_s() const { return commandCount() * period_s_; }

  /// Joint targets [rad] in joint order of command k < commandCount().
  const std::vector<double>& command(std::size_t k) const { return commands_[k]; }

 private:
  friend class BehaviorMaker;
  explicit Behavior(double period_s) : period_s_(period_s) {}
  template <typename GaitAngles>
  void play(const RobotDescription& robot, const BehaviorOptions& options, const GaitAngles& gait);

  double period_s_;
  Commands commands_;
};

/// Makes many behaviours of one robot and one set of options: what all gaits have in common is
/// worked out once. Immutable; const functions may be called from any thread.
class BehaviorMaker {
 public:
  /// The description must outlive it. Throws std::invalid_argument when options do not fit the
  /// robot.
  BehaviorMaker(const RobotDescription& robot, const BehaviorOptions& options);

  /// Behavior(robot, genome, options). Throws std::invalid_argument when the genome does not fit.
  Behavior make(const Genome& genome) const;

 private:
  const RobotDescription* robot_;
  BehaviorOptions options_;
  std::vector<GaitSignals> signals_;  // of each command of the gait
};

}  // namespace hexapod
