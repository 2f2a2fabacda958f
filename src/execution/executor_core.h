#pragma once

#include <cstdint>
#include <vector>

#include "execution/command_gate.h"
#include "execution/executor_options.h"
#include "execution/executor_status.h"
#include "execution/feedback_watch.h"
#include "execution/ramp.h"
#include "gait/behavior.h"
#include "gait/behavior_options.h"

namespace hexapod {

/// Decides what is sent in each command period, from arming to the last command.
///
/// Time is the number of the command period ("slot"), given to tick(). Slots left out between two
/// ticks are commands skipped: the behaviour goes on where the timeline is, there is never a burst.
/// Everything sent has passed the CommandGate. Nothing is sent while DISARMED, STOPPED or in FAULT,
/// and only arm() leaves the last two. What is played is a Behavior, command by command, the object
/// the learner evaluates: command k goes out in slot (slot of command 0) + k.
///
/// Used by one thread at a time. No function but the constructor allocates, locks or waits.
class ExecutorCore {
 public:
  ExecutorCore(const RobotDescription& robot, const BehaviorOptions& behavior,
               const ExecutorOptions& options);

  /// Requests. Each returns Reason::kNone when it was carried out, else why not; the mode then
  /// stays as it was.
  /// @{

  /// Stands up: a ramp from the measured pose (open loop: from the last command, at first from the
  /// neutral pose) to the neutral pose, then READY. The only way out of STOPPED and FAULT.
  Cause arm();
  /// arm() from DISARMED; refused when STOPPED or in FAULT.
  Cause stand();
  /// From READY: SITTING_DOWN, a ramp to the sitting pose, then DISARMED.
  Cause sit();
  /// Nothing more is sent, in any mode but STOPPED and FAULT, which stay.
  Cause disarm();
  /// From READY: plays the behaviour, beginning with the next tick. It must live until
  /// status().last_end.serial is status().serial.
  Cause start(const Behavior& behavior, std::int64_t entry_id);
  /// Breaks the behaviour off: HOLDING, then a ramp to the neutral pose, then READY.
  Cause cancel(Reason why);
  /// @}

  /// Nothing more is sent from this moment on until arm(), whatever the mode was; but with
  /// hold_on_stop the next tick yields one last command (status().holding).
  void stop(Reason why);
  /// Pressed stops; released does not re-arm, but while pressed arm() is refused.
  void setEStop(bool pressed);
  /// The publisher of the emergency stop lives.
  void heartbeat() { ticks_since_heartbeat_ = 0; }

  void feedback(const JointReadings& readings) { watch_.add(readings); }
  /// Joints that are believed dead, one flag per joint: nobody faults because they are not read or
  /// do not follow. They are commanded as before. While somebody `watched` the body, other legs in
  /// trouble may be doubted first (LegDoubts).
  void tolerate(const std::vector<char>& dead, bool watched) { watch_.tolerate(dead, watched); }

  /// So many commands that tick() gave out were never sent: newer ones overtook them.
  void overtaken(std::uint64_t commands);

  /// The command [rad] of this slot, in joint order, or nullptr when nothing is to be sent. Slots
  /// must grow; a slot that does not is answered with nullptr.
  const std::vector<double>* tick(std::int64_t slot);

  const ExecutorStatus& status() const { return status_; }

 private:
  bool closedLoop() const { return options_.feedback_timeout_s > 0.0; }
  Cause judged(Reason reason, int joint = -1, double value_rad = 0.0) const;
  Cause checkStart() const;
  void enter(ExecutorMode mode, Cause cause);
  void beginRamp(const std::vector<double>& from, const std::vector<double>& to, double hold_s);
  void endBehavior(Cause cause);
  void passTime(std::int64_t slot);
  void countSkipped(std::int64_t slot);
  bool eStopIsSilent() const;
  bool robotFollows();
  const std::vector<double>* lastWord();
  void finishMotion(std::int64_t index);
  void chooseTarget(std::int64_t index);
  bool arrivedAt(const std::vector<double>& pose_rad) const;

  ExecutorOptions options_;
  double period_s_;
  std::vector<double> neutral_;
  std::vector<double> sitting_;
  CommandGate gate_;
  Ramp ramp_;
  std::vector<double> target_;
  FeedbackWatch watch_;
  bool e_stop_ = false;
  std::int64_t ticks_since_heartbeat_ = -1;  // -1: none yet
  const Behavior* behavior_ = nullptr;
  bool begins_ = false;  // the motion's first slot is the next tick
  std::int64_t begin_slot_ = 0;
  std::int64_t last_slot_;
  std::int64_t sent_slot_ = 0;
  std::uint32_t skipped_ = 0;  // commands of the behaviour
  ExecutorStatus status_;
};

}  // namespace hexapod
