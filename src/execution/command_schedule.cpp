#include "execution/command_schedule.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>

namespace hexapod {
namespace {

// Thirty seconds of commands; more is a runaway sender.
constexpr std::size_t kMaxWaiting = 1000;
constexpr std::int64_t kForeign_ns = 1'000'000'000;

}  // namespace

CommandSchedule::Arrival CommandSchedule::add(std::int64_t stamp_ns, std::int64_t last_step_ns,
                                              const std::vector<double>& targets_rad) {
  if (waiting_.size() >= kMaxWaiting) return Arrival::kFull;
  Arrival arrival = Arrival::kScheduled;
  std::int64_t acts_ns = stamp_ns + latency_ns_;
  if (stamp_ns == 0) {
    acts_ns = last_step_ns;
  } else if (std::abs(stamp_ns - last_step_ns) > kForeign_ns) {
    acts_ns = last_step_ns;
    arrival = Arrival::kForeign;
  } else if (acts_ns < acting_since_ns_) {
    return Arrival::kOld;
  } else if (acts_ns <= last_step_ns) {
    arrival = Arrival::kLate;
  }
  if (arrival != Arrival::kForeign) newest_stamp_ns_ = std::max(newest_stamp_ns_, stamp_ns);
  waiting_[acts_ns] = targets_rad;
  return arrival;
}

const std::vector<double>* CommandSchedule::due(std::int64_t step_ns) {
  const auto end = waiting_.upper_bound(step_ns);
  if (end == waiting_.begin()) return nullptr;
  const auto newest = std::prev(end);
  acting_since_ns_ = newest->first;
  acting_ = std::move(newest->second);
  waiting_.erase(waiting_.begin(), end);
  return &acting_;
}

void CommandSchedule::clear() {
  waiting_.clear();
  acting_since_ns_ = 0;
}

}  // namespace hexapod
