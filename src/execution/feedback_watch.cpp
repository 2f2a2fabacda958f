#include "execution/feedback_watch.h"

#include <algorithm>
#include <cmath>

namespace hexapod {
namespace {

// A joint told to go this far is seen to move by any encoder.
constexpr double kMoved_rad = 0.2;
// A leg's joints may be jammed together; this many that stand still are a driver that repeats
// itself.
constexpr int kManyJoints = 4;

Cause about(Reason reason, int joint, double value_rad = 0.0) {
  Cause cause;
  cause.reason = reason;
  cause.joint = joint;
  cause.value_rad = value_rad;
  return cause;
}

}  // namespace

FeedbackWatch::FeedbackWatch(const RobotDescription& robot, double period_s,
                             const ExecutorOptions& options)
    : period_s_(period_s),
      timeout_s_(options.feedback_timeout_s),
      max_tracking_error_rad_(options.max_tracking_error_rad),
      tracking_timeout_s_(options.tracking_timeout_s),
      measured_(robot.neutralPose()),
      joints_(measured_.size()),
      doubts_(robot, period_s, options) {}

void FeedbackWatch::tolerate(const std::vector<char>& dead, bool watched) {
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    if ((dead[j] != 0) != tolerates(j)) joints_[j].off = 0;
  }
  doubts_.tolerate(dead, watched);
}

void FeedbackWatch::add(const JointReadings& readings) {
  contested_joint_ = readings.contested_joint;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    State& joint = joints_[j];
    if (readings.counts[j] == joint.count) continue;
    joint.count = readings.counts[j];
    joint.age_ticks = 0;
    joint.is_new = true;
    changed_ = changed_ || (!tolerates(j) && readings.angles_rad[j] != measured_[j]);
    measured_[j] = readings.angles_rad[j];
  }
}

void FeedbackWatch::passTick(const ExecutorStatus& status) {
  doubts_.passTick(status);
  for (State& joint : joints_) {
    if (joint.age_ticks >= 0) ++joint.age_ticks;
  }
}

void FeedbackWatch::forgive() {
  for (State& joint : joints_) {
    joint.unjudged = 0;
    joint.off = 0;
    joint.is_new = false;
  }
  doubts_.forgive();
  changed_ = true;
}

bool FeedbackWatch::isSilent(std::size_t joint) const {
  const std::int64_t age_ticks = joints_[joint].age_ticks;
  // A reading that came since the tick before counts as new.
  return age_ticks < 0 || static_cast<double>(age_ticks - 1) * period_s_ > timeout_s_;
}

bool FeedbackWatch::isOff(std::size_t joint) const {
  return static_cast<double>(joints_[joint].off) * period_s_ > tracking_timeout_s_;
}

int FeedbackWatch::firstFault(bool (FeedbackWatch::*trouble)(std::size_t) const) {
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    if ((this->*trouble)(j) && !doubts_.excuses(j)) return static_cast<int>(j);
  }
  return -1;
}

bool FeedbackWatch::someJointIsOff() const {
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    if (isOff(j)) return true;
  }
  return false;
}

// Who is armed knows every joint's angle: nothing is doubted here.
Cause FeedbackWatch::checkStart() const {
  if (contested_joint_ >= 0) return about(Reason::kTwoSources, contested_joint_);
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    if (isSilent(j) && !tolerates(j)) return about(Reason::kNoFeedback, static_cast<int>(j));
  }
  return {};
}

Cause FeedbackWatch::check(const std::vector<double>& command_rad) {
  watchChanges(command_rad);
  compare(command_rad);
  const int silent = firstFault(&FeedbackWatch::isSilent);
  if (silent >= 0) return about(Reason::kFeedbackLost, silent);
  int moved = -1;
  const int count = movedJoints(moved);
  const double unchanged_s = static_cast<double>(unchanged_ticks_) * period_s_;
  const bool many =
      count >= kManyJoints && someJointIsOff() && unchanged_s > tracking_timeout_s_ / 2.0;
  if (count > 0 && (many || unchanged_s > timeout_s_ + tracking_timeout_s_)) {
    return about(Reason::kFeedbackFrozen, moved);
  }
  const int off = firstFault(&FeedbackWatch::isOff);
  return off < 0 ? Cause() : about(Reason::kNotFollowing, off, joints_[off].off_rad);
}

void FeedbackWatch::watchChanges(const std::vector<double>& command_rad) {
  bool moved = false;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    State& joint = joints_[j];
    if (changed_) joint.commanded_rad = command_rad[j];
    const bool far = std::abs(command_rad[j] - joint.commanded_rad) > kMoved_rad;
    joint.moved = !changed_ && !tolerates(j) && (joint.moved || far);
    moved = moved || joint.moved;
  }
  unchanged_ticks_ = moved ? unchanged_ticks_ + 1 : 0;
  changed_ = false;
}

// How many joints were told to move since a reading last changed, and the first of them.
int FeedbackWatch::movedJoints(int& first) const {
  int count = 0;
  for (std::size_t j = joints_.size(); j-- > 0;) {
    if (!joints_[j].moved) continue;
    ++count;
    first = static_cast<int>(j);
  }
  return count;
}

// How long each joint has been off its command.
void FeedbackWatch::compare(const std::vector<double>& command_rad) {
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    State& joint = joints_[j];
    ++joint.unjudged;
    if (!joint.is_new) continue;
    joint.is_new = false;
    joint.off_rad = std::abs(measured_[j] - command_rad[j]);
    // A slow driver's reading stands for all the ticks since the one before.
    const bool off = joint.off_rad > max_tracking_error_rad_;
    joint.off = std::max<std::int64_t>(0, joint.off + (off ? joint.unjudged : -joint.unjudged));
    joint.unjudged = 0;
    if (max_tracking_error_rad_ <= 0.0 || tolerates(j)) joint.off = 0;
  }
}

}  // namespace hexapod
