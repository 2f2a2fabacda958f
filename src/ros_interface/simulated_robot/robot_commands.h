#pragma once

#include <sensor_msgs/JointState.h>

#include <cstdint>
#include <string>
#include <vector>

#include "common/random.h"
#include "execution/command_schedule.h"
#include "execution/joint_matcher.h"
#include "robot/robot_description.h"

namespace hexapod {

/// Takes joint commands and holds each until its step. Physics sees only commands that name every
/// joint once, finite and within its limits; the others are counted and left out. Knows no wire;
/// used by one thread.
class RobotCommands {
 public:
  struct Counts {
    std::uint64_t received = 0;
    std::uint64_t refused = 0;
    std::uint64_t late = 0;     ///< came after the step they should act from
    std::uint64_t foreign = 0;  ///< stamped by another clock
    std::uint64_t dropped = 0;  ///< out of order, or too many
    std::uint64_t lost = 0;     ///< by the disturbance
  };

  RobotCommands(const RobotDescription& robot, std::int64_t latency_ns);

  /// False when it is refused: see problem().
  bool take(const sensor_msgs::JointState& command);

  /// The targets that act from the step that begins at `step_ns`; nullptr: those before go on.
  const std::vector<double>* due(std::int64_t step_ns);

  /// True when the stream of stamped commands is alive and the one for `time_ns` has not come yet.
  bool expects(std::int64_t time_ns) const;
  /// The stream is over until the next command.
  void giveUp() { period_ns_ = 0; }

  void clear() { schedule_.clear(); }

  /// From now on commands act so much later, and a share of them is lost. (Which ones is the same
  /// in every run.)
  void disturb(std::int64_t latency_ns, double lost_share);

  const Counts& counts() const { return counts_; }
  /// Sentence about the last command refused; empty when none was.
  const std::string& problem() const { return problem_; }

 private:
  bool withinLimits(const std::vector<double>& targets_rad);

  std::vector<Joint> joints_;
  JointMatcher matcher_;
  CommandSchedule schedule_;
  std::int64_t latency_ns_ = 0;  // beyond the schedule's
  double lost_share_ = 0.0;
  Random random_{1};
  std::int64_t last_step_ns_ = 0;
  std::int64_t period_ns_ = 0;  // between the two newest commands; 0: unknown
  Counts counts_;
  std::string problem_;
};

}  // namespace hexapod
