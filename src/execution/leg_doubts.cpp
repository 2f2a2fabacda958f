#include "execution/leg_doubts.h"

#include <algorithm>
#include <cmath>

namespace hexapod {
namespace {

// Bits of doubted().
constexpr std::size_t kMostLegs = 64;

}  // namespace

LegDoubts::LegDoubts(const RobotDescription& robot, double period_s, const ExecutorOptions& options)
    : max_dead_legs_(options.max_dead_legs),
      patience_ticks_(std::llround(options.belief_patience_s / period_s)),
      dead_(robot.jointCount(), 0),
      legs_(robot.legs.size()) {
  for (std::size_t leg = 0; leg < robot.legs.size(); ++leg) {
    leg_of_joint_.insert(leg_of_joint_.end(), robot.legs[leg].segments.size(), leg);
  }
}

void LegDoubts::tolerate(const std::vector<char>& dead, bool watched) {
  watched_ = watched;
  std::copy_n(dead.begin(), dead_.size(), dead_.begin());
  for (std::size_t leg = 0; leg < legs_.size(); ++leg) {
    bool is_dead = false;
    for (std::size_t j = 0; j < dead_.size(); ++j) {
      is_dead = is_dead || (leg_of_joint_[j] == leg && dead_[j] != 0);
    }
    // Judged: what comes next is new trouble.
    if (is_dead != legs_[leg].is_dead) legs_[leg].trust = Trust::kTrusted;
    legs_[leg].is_dead = is_dead;
  }
}

bool LegDoubts::excuses(std::size_t joint) {
  if (tolerates(joint)) return true;
  const std::size_t index = leg_of_joint_[joint];
  Leg& leg = legs_[index];
  if (!watched_ || leg.trust == Trust::kSpent) return false;
  if (leg.trust == Trust::kDoubted) return true;
  if (legsLost() >= max_dead_legs_ || index >= kMostLegs) return false;
  leg.trust = Trust::kDoubted;
  leg.was_watched = false;
  leg.serial = serial_;
  leg.patience_ticks = patience_ticks_;
  return true;
}

void LegDoubts::passTick(const ExecutorStatus& status) {
  serial_ = status.serial;
  for (Leg& leg : legs_) {
    if (leg.trust != Trust::kDoubted) continue;
    const BehaviorEnd& end = status.last_end;
    // Behaviours of which commands were left out tell nobody anything.
    const bool whole = end.cause.reason == Reason::kFinished && end.skipped == 0;
    leg.was_watched = leg.was_watched || (end.serial > leg.serial && whole);
    if (leg.was_watched && --leg.patience_ticks < 0) leg.trust = Trust::kSpent;
  }
}

void LegDoubts::forgive() {
  for (Leg& leg : legs_) leg.trust = Trust::kTrusted;
}

std::uint64_t LegDoubts::doubted() const {
  std::uint64_t bits = 0;
  for (std::size_t leg = 0; leg < std::min(legs_.size(), kMostLegs); ++leg) {
    if (legs_[leg].trust == Trust::kDoubted) bits |= std::uint64_t{1} << leg;
  }
  return bits;
}

std::int64_t LegDoubts::legsLost() const {
  return static_cast<std::int64_t>(std::count_if(legs_.begin(), legs_.end(), [](const Leg& leg) {
    return leg.is_dead || leg.trust == Trust::kDoubted;
  }));
}

}  // namespace hexapod
