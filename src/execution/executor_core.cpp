#include "execution/executor_core.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "execution/sitting_pose.h"

namespace hexapod {
namespace {

// Below the resolution of any servo.
constexpr double kArrived_rad = 1e-9;

constexpr std::int64_t kNoSlot = std::numeric_limits<std::int64_t>::min();

}  // namespace

ExecutorCore::ExecutorCore(const RobotDescription& robot, const BehaviorOptions& behavior,
                           const ExecutorOptions& options)
    : options_(options),
      period_s_(behavior.command_period_s),
      neutral_(robot.neutralPose()),
      sitting_(sittingPose(robot, options.sit_signal)),
      gate_(robot, behavior.command_period_s, options.gate),
      ramp_(robot),
      target_(neutral_),
      watch_(robot, period_s_, options),
      last_slot_(kNoSlot) {}

Cause ExecutorCore::arm() {
  if (e_stop_) return judged(Reason::kEStop);
  if (sendsCommands(status_.mode)) return judged(Reason::kAlreadyArmed);
  const Cause problem = checkStart();
  if (!problem.accepted()) return problem;
  gate_.reset(closedLoop() ? watch_.measured() : gate_.last());
  watch_.forgive();
  status_.holding = false;
  beginRamp(gate_.last(), neutral_, 0.0);
  enter(ExecutorMode::kStandingUp, {Reason::kArmRequested});
  return {};
}

Cause ExecutorCore::checkStart() const {
  if (eStopIsSilent()) return judged(Reason::kEStopSilent);
  if (!closedLoop()) return {};
  const Cause problem = watch_.checkStart();
  if (!problem.accepted()) return judged(problem.reason, problem.joint);
  if (options_.far_start == FarStart::kRamp) return {};
  for (std::size_t j = 0; j < neutral_.size(); ++j) {
    const double off_rad = std::abs(watch_.measured()[j] - neutral_[j]);
    if (off_rad > options_.start_tolerance_rad && !watch_.tolerates(j)) {
      return judged(Reason::kFarFromNeutral, static_cast<int>(j), off_rad);
    }
  }
  return {};
}

Cause ExecutorCore::stand() {
  const bool locked =
      status_.mode == ExecutorMode::kStopped || status_.mode == ExecutorMode::kFault;
  return locked ? judged(status_.cause.reason, status_.cause.joint, status_.cause.value_rad)
                : arm();
}

Cause ExecutorCore::sit() {
  if (status_.mode != ExecutorMode::kReady) return judged(Reason::kNotReady);
  beginRamp(gate_.last(), sitting_, 0.0);
  enter(ExecutorMode::kSittingDown, {Reason::kSittingDown});
  return {};
}

Cause ExecutorCore::disarm() {
  if (!sendsCommands(status_.mode)) return {};
  endBehavior({Reason::kDisarmRequested});
  enter(ExecutorMode::kDisarmed, {Reason::kDisarmRequested});
  return {};
}

Cause ExecutorCore::start(const Behavior& behavior, std::int64_t entry_id) {
  if (status_.mode != ExecutorMode::kReady) return judged(Reason::kNotReady);
  if (behavior.commandCount() == 0 || behavior.command(0).size() != neutral_.size()) {
    return judged(Reason::kBadBehavior);
  }
  behavior_ = &behavior;
  begins_ = true;
  skipped_ = 0;
  ++status_.serial;
  status_.entry_id = entry_id;
  status_.first_slot = last_slot_ + 1;
  status_.played = 0;
  enter(ExecutorMode::kWalking, {Reason::kPlaying});
  return {};
}

Cause ExecutorCore::cancel(Reason why) {
  if (status_.mode != ExecutorMode::kWalking) return judged(Reason::kNothingToCancel);
  beginRamp(gate_.last(), neutral_, options_.hold_time_s);
  enter(ExecutorMode::kHolding, {why});
  return {};
}

void ExecutorCore::stop(Reason why) {
  if (status_.mode == ExecutorMode::kStopped) return;
  status_.holding =
      options_.hold_on_stop && sendsCommands(status_.mode) && why != Reason::kShutDown;
  endBehavior({why});
  enter(ExecutorMode::kStopped, {why});
}

void ExecutorCore::setEStop(bool pressed) {
  e_stop_ = pressed;
  if (pressed) stop(Reason::kEStop);
}

void ExecutorCore::overtaken(std::uint64_t commands) {
  status_.commands -= commands;
  status_.skipped += commands;
  if (status_.mode == ExecutorMode::kWalking) skipped_ += static_cast<std::uint32_t>(commands);
}

const std::vector<double>* ExecutorCore::tick(std::int64_t slot) {
  if (slot <= last_slot_) return nullptr;
  passTime(slot);
  if (status_.holding) return lastWord();
  if (!sendsCommands(status_.mode) || !robotFollows()) return nullptr;
  if (begins_) begin_slot_ = slot;
  begins_ = false;
  finishMotion(slot - begin_slot_);
  if (!sendsCommands(status_.mode)) return nullptr;
  chooseTarget(slot - begin_slot_);
  if (gate_.pass(target_) == CommandGate::Passage::kRefused) {
    endBehavior({Reason::kCommandRefused});
    enter(ExecutorMode::kFault, {Reason::kCommandRefused});
    return nullptr;
  }
  status_.clamped = gate_.clampedCount();
  ++status_.commands;
  sent_slot_ = slot;
  return &gate_.last();
}

void ExecutorCore::passTime(std::int64_t slot) {
  if (last_slot_ != kNoSlot && sendsCommands(status_.mode)) countSkipped(slot);
  if (slot != last_slot_ + 1) gate_.rest();
  last_slot_ = slot;
  watch_.passTick(status_);
  if (ticks_since_heartbeat_ >= 0) ++ticks_since_heartbeat_;
}

void ExecutorCore::countSkipped(std::int64_t slot) {
  status_.skipped += static_cast<std::uint64_t>(slot - last_slot_ - 1);
  if (status_.mode != ExecutorMode::kWalking || begins_) return;
  const auto count = static_cast<std::int64_t>(behavior_->commandCount());
  const std::int64_t begin = std::min(last_slot_ + 1 - begin_slot_, count);
  const std::int64_t end = std::min(slot - begin_slot_, count);
  skipped_ += static_cast<std::uint32_t>(end - begin);
}

bool ExecutorCore::eStopIsSilent() const {
  if (options_.e_stop_timeout_s <= 0.0) return false;
  const double silent_s = static_cast<double>(ticks_since_heartbeat_ - 1) * period_s_;
  return ticks_since_heartbeat_ < 0 || silent_s > options_.e_stop_timeout_s;
}

// False when the robot is none to walk with: a stop or a fault by now.
bool ExecutorCore::robotFollows() {
  if (eStopIsSilent()) {
    stop(Reason::kEStopSilent);
    return false;
  }
  if (!closedLoop()) return true;
  const Cause problem = watch_.check(gate_.last());
  status_.doubted_legs = watch_.doubtedLegs();
  if (problem.accepted()) return true;
  endBehavior(problem);
  enter(ExecutorMode::kFault, problem);
  return false;
}

// What is sent once after a stop: stay where you are.
const std::vector<double>* ExecutorCore::lastWord() {
  status_.holding = false;
  gate_.pass(closedLoop() ? watch_.measured() : gate_.last());
  ++status_.commands;
  return &gate_.last();
}

void ExecutorCore::finishMotion(std::int64_t index) {
  const bool walking = status_.mode == ExecutorMode::kWalking;
  if (walking) {
    status_.first_slot = begin_slot_;
    status_.played = index;
  }
  if (status_.mode == ExecutorMode::kReady) return;
  const std::int64_t length =
      walking ? static_cast<std::int64_t>(behavior_->commandCount()) : ramp_.length() + 1;
  // A late loop or a behaviour without a way back may still have to reach its end.
  if (index < length || !arrivedAt(walking ? neutral_ : ramp_.goal())) return;
  if (status_.mode == ExecutorMode::kSittingDown) {
    enter(ExecutorMode::kDisarmed, {Reason::kSatDown});
    return;
  }
  const Cause why = walking ? Cause{Reason::kFinished} : status_.cause;
  endBehavior(why);
  enter(ExecutorMode::kReady, {Reason::kNeutral});
}

void ExecutorCore::chooseTarget(std::int64_t index) {
  if (status_.mode != ExecutorMode::kReady && status_.mode != ExecutorMode::kWalking) {
    ramp_.pose(index, target_);
    return;
  }
  const bool playing = status_.mode == ExecutorMode::kWalking &&
                       index < static_cast<std::int64_t>(behavior_->commandCount());
  const std::vector<double>& source =
      playing ? behavior_->command(static_cast<std::size_t>(index)) : neutral_;
  std::copy_n(source.begin(), target_.size(), target_.begin());
}

bool ExecutorCore::arrivedAt(const std::vector<double>& pose_rad) const {
  return std::equal(pose_rad.begin(), pose_rad.end(), gate_.last().begin(),
                    [](double goal, double sent) { return std::abs(goal - sent) <= kArrived_rad; });
}

Cause ExecutorCore::judged(Reason reason, int joint, double value_rad) const {
  return {reason, status_.mode, joint, value_rad};
}

void ExecutorCore::enter(ExecutorMode mode, Cause cause) {
  status_.mode = mode;
  status_.cause = cause;
}

void ExecutorCore::beginRamp(const std::vector<double>& from, const std::vector<double>& to,
                             double hold_s) {
  ramp_.plan(from, to, hold_s, options_.ramp_time_s, period_s_);
  begins_ = true;
}

void ExecutorCore::endBehavior(Cause cause) {
  if (status_.last_end.serial == status_.serial) return;
  status_.last_end = {status_.serial, cause, sent_slot_, skipped_};
  status_.entry_id = -1;
  behavior_ = nullptr;
}

}  // namespace hexapod
