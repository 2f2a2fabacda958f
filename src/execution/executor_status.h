#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace hexapod {

/// What the executor is doing; the numbers of msg/ExecutorState.
enum class ExecutorMode : std::uint8_t {
  kDisarmed = 0,
  kStandingUp = 1,
  kReady = 2,
  kWalking = 3,
  kHolding = 4,
  kStopped = 5,
  kFault = 6,
  kSittingDown = 7
};

/// "DISARMED", "STANDING_UP", ..
const char* toString(ExecutorMode mode);

/// True in the modes that send a command every period.
bool sendsCommands(ExecutorMode mode);

/// Why the executor is in its mode, or does not do what it was asked.
enum class Reason : std::uint8_t {
  kNone,  ///< a request was carried out
  kNeverArmed,
  kDisarmRequested,
  kSatDown,
  kArmRequested,
  kNeutral,  ///< stands in the neutral pose
  kPlaying,
  kFinished,  ///< a behaviour came to its end
  kCancelled,
  kTimeJumped,
  kRobotReset,
  kSittingDown,
  kStopRequested,
  kEStop,
  kEStopSilent,
  kShutDown,
  kFeedbackLost,    ///< joint: the first that is not read
  kFeedbackFrozen,  ///< joint: one whose commands moved though no reading changed
  kTwoSources,      ///< joint: reported by two nodes
  kNotFollowing,    ///< joint, value: tracking error [rad]
  kCommandRefused,  ///< the gate refused a command: not finite or of the wrong length
  kNoFeedback,
  kFarFromNeutral,  ///< joint, value: distance [rad]
  kAlreadyArmed,
  kNotReady,
  kNothingToCancel,
  kBadBehavior,
  kOvertaken,  ///< a stop came after the request
  kNoAnswer    ///< the command loop did not answer in time
};

/// A reason with its numbers; text is made outside of the command loop.
struct Cause {
  Reason reason = Reason::kNone;
  ExecutorMode mode = ExecutorMode::kDisarmed;  ///< when a request was judged
  int joint = -1;
  double value_rad = 0.0;

  bool accepted() const { return reason == Reason::kNone; }
};

/// One sentence for a person: what was found and what to do.
std::string sentence(const Cause& cause, const std::vector<std::string>& joint_names);

/// How a behaviour ended.
struct BehaviorEnd {
  std::uint64_t serial = 0;    ///< of the behaviour, from 1; 0: none ended yet
  Cause cause;                 ///< kFinished when it came to its end
  std::int64_t last_slot = 0;  ///< command period of its last command
  std::uint32_t skipped = 0;   ///< of its commands, left out because the loop was late
};

/// Everything the executor tells; copied between threads, so it holds no pointers.
struct ExecutorStatus {
  ExecutorMode mode = ExecutorMode::kDisarmed;
  Cause cause{Reason::kNeverArmed};
  std::int64_t entry_id = -1;   ///< entry being played; -1: none or a bare genome
  std::uint64_t serial = 0;     ///< behaviours accepted
  std::int64_t first_slot = 0;  ///< command period of the behaviour's first command
  std::int64_t played = 0;      ///< command periods since the behaviour began
  BehaviorEnd last_end;
  std::uint64_t doubted_legs = 0;  ///< a bit for each leg whose trouble is no fault yet
  bool holding = false;            ///< stopped, and one last command is still to be sent
  std::uint64_t commands = 0;      ///< sent since the start
  std::uint64_t skipped = 0;       ///< left out because the loop or the sending thread was late
  std::uint64_t clamped = 0;       ///< held back by the gate
};

}  // namespace hexapod
