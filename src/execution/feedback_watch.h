#pragma once

#include <cstdint>
#include <vector>

#include "execution/executor_options.h"
#include "execution/executor_status.h"
#include "execution/joint_readings.h"
#include "execution/leg_doubts.h"
#include "robot/robot_description.h"

namespace hexapod {

/// Watches what the robot's joints do against what they are told: is every joint read, does it
/// follow, do the readings live?
///
/// Time passes in ticks of the command loop, not on a clock: after a stall of the whole process a
/// reading is as old as before. Joints may be read at different times and slower than they are
/// commanded. Joints that are believed dead are not judged, and trouble of a leg in doubt is no
/// fault (LegDoubts). No function but the constructor allocates, locks or waits. Not thread-safe.
class FeedbackWatch {
 public:
  /// `period_s` of a tick. Until a joint is read, measured() is its neutral angle.
  FeedbackWatch(const RobotDescription& robot, double period_s, const ExecutorOptions& options);

  /// `dead`: one flag per joint, 1 for a joint that is believed dead. `watched`: somebody will say
  /// so when another one is.
  void tolerate(const std::vector<char>& dead, bool watched);

  void add(const JointReadings& readings);

  /// One command period goes by; `status` is that of the period before.
  void passTick(const ExecutorStatus& status);

  /// Joints' errors so far are forgotten.
  void forgive();

  /// May the robot be armed? Reason::kNone, kNoFeedback or kTwoSources.
  Cause checkStart() const;

  /// Judges a period in which `command_rad` was the last command: Reason::kNone, kFeedbackLost,
  /// kNotFollowing or kFeedbackFrozen. Once per tick.
  Cause check(const std::vector<double>& command_rad);

  const std::vector<double>& measured() const { return measured_; }
  bool tolerates(std::size_t joint) const { return doubts_.tolerates(joint); }
  /// A bit for each leg whose trouble is no fault yet.
  std::uint64_t doubtedLegs() const { return doubts_.doubted(); }

 private:
  struct State {
    std::uint64_t count = 0;      // readings seen
    std::int64_t age_ticks = -1;  // of the last one; -1: none
    bool is_new = false;          // since the last check()
    std::int64_t unjudged = 0;    // ticks since the joint was last judged
    std::int64_t off = 0;         // ticks off its command less those on it
    double off_rad = 0.0;         // distance from its command when last judged
    double commanded_rad = 0.0;   // when a reading last changed
    bool moved = false;           // its command is far from that
  };

  bool isSilent(std::size_t joint) const;
  bool isOff(std::size_t joint) const;
  /// The first joint in this trouble that is not excused; -1: none.
  int firstFault(bool (FeedbackWatch::*trouble)(std::size_t) const);
  bool someJointIsOff() const;
  void compare(const std::vector<double>& command_rad);
  void watchChanges(const std::vector<double>& command_rad);
  int movedJoints(int& first) const;

  double period_s_;
  double timeout_s_;
  double max_tracking_error_rad_;
  double tracking_timeout_s_;
  std::vector<double> measured_;
  std::vector<State> joints_;
  LegDoubts doubts_;
  int contested_joint_ = -1;
  bool changed_ = true;               // a reading has changed since the last check()
  std::int64_t unchanged_ticks_ = 0;  // since some joint was moved and no reading changed
};

}  // namespace hexapod
