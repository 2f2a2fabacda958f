#include "execution/feedback_merger.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <stdexcept>

namespace hexapod {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;
// A contest is remembered until a source at 1 Hz had its turn.
constexpr std::int64_t kContest_ns = 2 * kSecond_ns;

}  // namespace

FeedbackMerger::FeedbackMerger(const std::vector<std::string>& names, double timeout_s)
    : names_(names),
      timeout_ns_(static_cast<std::int64_t>(timeout_s * static_cast<double>(kSecond_ns))),
      patience_ns_(2 * timeout_ns_ + kSecond_ns),
      claims_(names.size()),
      readings_(names.size()) {
  for (std::size_t j = 0; j < names.size(); ++j) {
    if (index_.emplace(names[j], j).second) continue;
    throw std::invalid_argument("Joint '" + names[j] + "' occurs twice; names must be unique.");
  }
}

FeedbackMerger::Result FeedbackMerger::add(const FeedbackMessage& message) {
  if (!findJoints(message)) return Result::kRefused;
  if (found_.empty()) return Result::kNothing;
  if (!timeOf(message.source, message.stamp_ns, message.arrival)) return Result::kRefused;
  bool used = false;
  for (const auto& [joint, position_rad] : found_)
    used = take(joint, position_rad, message) || used;
  readings_.contested_joint = contestedJoint(message.arrival.steady_ns);
  return used ? Result::kUsed : Result::kNothing;
}

std::optional<std::int64_t> FeedbackMerger::timeOf(const std::string& source, std::int64_t stamp_ns,
                                                   const Arrival& arrival) {
  if (stamp_ns == 0) return arrival.steady_ns;
  SourceClock& clock = clockOf(source, arrival.steady_ns);
  if (clock.isFresh(stamp_ns, arrival)) return clock.steady_ns(stamp_ns);
  const std::int64_t age_ns = arrival.ros_ns - stamp_ns;
  refuse("It is stamped " + std::to_string(std::abs(age_ns) / 1'000'000) + " ms " +
         (age_ns > 0 ? "ago" : "from now") + " by " + source +
         "; expected a fresh stamp (or 0). Synchronise the clocks of the machines.");
  return std::nullopt;
}

SourceClock& FeedbackMerger::clockOf(const std::string& name, std::int64_t now_ns) {
  if (sources_.count(name) == 0) {
    for (auto it = sources_.begin(); it != sources_.end();) {
      it = now_ns - it->second.heard_ns > patience_ns_ ? sources_.erase(it) : std::next(it);
    }
  }
  Source& source = sources_.emplace(name, Source{SourceClock(timeout_ns_), 0}).first->second;
  source.heard_ns = now_ns;
  return source.clock;
}

// The robot's joints of a message into found_; false when the message is refused.
bool FeedbackMerger::findJoints(const FeedbackMessage& message) {
  found_.clear();
  for (std::size_t i = 0; i < message.names.size(); ++i) {
    const auto known = index_.find(message.names[i]);
    if (known == index_.end()) continue;
    const std::string& name = message.names[i];
    if (message.names.size() != message.positions_rad.size()) {
      refuse("It has " + std::to_string(message.names.size()) + " names and " +
             std::to_string(message.positions_rad.size()) +
             " positions; expected one position per name.");
      return false;
    }
    const std::size_t joint = known->second;
    if (std::any_of(found_.begin(), found_.end(),
                    [joint](const auto& found) { return found.first == joint; })) {
      refuse("Joint '" + name + "' occurs twice.");
      return false;
    }
    if (!std::isfinite(message.positions_rad[i])) {
      refuse("The position of joint '" + name + "' is not a finite number.");
      return false;
    }
    found_.emplace_back(joint, message.positions_rad[i]);
  }
  return true;
}

// True when this is a new reading of the joint.
bool FeedbackMerger::take(std::size_t joint, double position_rad, const FeedbackMessage& message) {
  Claim& claim = claims_[joint];
  const std::int64_t now_ns = message.arrival.steady_ns;
  const bool free = claim.owner.empty() || now_ns - claim.owner_heard_ns > patience_ns_;
  if (free) claim.owner = message.source;
  if (claim.owner != message.source) {
    claim.rival = message.source;
    claim.rival_heard_ns = now_ns;
    return false;
  }
  claim.owner_heard_ns = now_ns;
  if (!free && message.stamp_ns != 0 && message.stamp_ns == claim.stamp_ns) return false;
  claim.stamp_ns = message.stamp_ns;
  readings_.angles_rad[joint] = position_rad;
  ++readings_.counts[joint];
  return true;
}

int FeedbackMerger::contestedJoint(std::int64_t now_ns) const {
  for (std::size_t j = 0; j < claims_.size(); ++j) {
    const bool contested = !claims_[j].rival.empty() && claims_[j].rival != claims_[j].owner &&
                           now_ns - claims_[j].rival_heard_ns < kContest_ns;
    if (contested) return static_cast<int>(j);
  }
  return -1;
}

std::string FeedbackMerger::rivals(int joint) const {
  if (joint < 0 || static_cast<std::size_t>(joint) >= claims_.size()) return "";
  const Claim& claim = claims_[static_cast<std::size_t>(joint)];
  return claim.rival.empty() ? "" : claim.owner + " and " + claim.rival;
}

FeedbackMerger::Result FeedbackMerger::refuse(const std::string& problem) {
  problem_ = problem;
  return Result::kRefused;
}

}  // namespace hexapod
