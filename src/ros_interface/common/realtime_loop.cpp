#include "ros_interface/common/realtime_loop.h"

#include <algorithm>
#include <cstdlib>

#include "ros_interface/common/realtime.h"

namespace hexapod {
namespace {

// A wall clock is taken for set, not slewed, beyond this.
constexpr std::int64_t kClockSet_ns = 20'000'000;
constexpr std::int64_t kClockPoll_ns = 300'000;

}  // namespace

RealtimeLoop::RealtimeLoop(const Options& options, const Clock& clock, Callbacks callbacks)
    : options_(options),
      period_ns_(options.period_ns),
      clock_(clock),
      callbacks_(std::move(callbacks)) {}

RealtimeLoop::~RealtimeLoop() { stop(); }

void RealtimeLoop::start() {
  running_ = true;
  thread_ = std::thread([this] { run(); });
}

void RealtimeLoop::stop() {
  running_ = false;
  if (thread_.joinable()) thread_.join();
}

ros::Time RealtimeLoop::stamp(std::int64_t slot) const {
  return timeFromNs(first_stamp_ns_ + slot * period_ns_);
}

LoopTiming RealtimeLoop::timing() const {
  LoopTiming timing;
  timing.ticks = ticks_;
  timing.skipped = skipped_;
  timing.largest_lateness_s = 1e-9 * static_cast<double>(largest_late_ns_);
  if (timing.ticks > 0) {
    timing.mean_lateness_s =
        1e-9 * static_cast<double>(sum_late_ns_) / static_cast<double>(timing.ticks);
  }
  return timing;
}

void RealtimeLoop::run() {
  if (options_.realtime) realtime_refusal_ = askForRealtimePriority(RealtimePriority::kLoop);
  clock_.isSimulated() ? runSimulated() : runSteady();
}

// ROS time at the steady time 0 [ns]. The reading with the shortest gap between two looks at the
// steady clock is the one nobody interrupted.
std::int64_t RealtimeLoop::wallFromSteady_ns() const {
  std::int64_t best_gap_ns = kSecond_ns;
  std::int64_t best_ns = 0;
  for (int i = 0; i < 3; ++i) {
    const std::int64_t before_ns = clock_.steadyNow_ns();
    const std::int64_t wall_ns = toNs(clock_.rosNow());
    const std::int64_t gap_ns = clock_.steadyNow_ns() - before_ns;
    if (gap_ns >= best_gap_ns) continue;
    best_gap_ns = gap_ns;
    best_ns = wall_ns - before_ns - gap_ns / 2;
  }
  return best_ns;
}

void RealtimeLoop::runSteady() {
  const std::int64_t start_ns = clock_.steadyNow_ns();
  first_due_ns_ = start_ns;
  std::int64_t wall_offset_ns = wallFromSteady_ns();
  first_stamp_ns_ = start_ns + wall_offset_ns;
  for (std::int64_t slot = 0; running_; ++slot) {
    clock_.sleepUntil(start_ns + slot * period_ns_);
    const std::int64_t elapsed_ns = clock_.steadyNow_ns() - start_ns;
    const std::int64_t late_ns = elapsed_ns - slot * period_ns_;
    slot = std::max(slot, elapsed_ns / period_ns_);
    const std::int64_t offset_ns = wallFromSteady_ns();
    if (std::abs(offset_ns - wall_offset_ns) > kClockSet_ns && callbacks_.may_move_stamps()) {
      first_stamp_ns_ += offset_ns - wall_offset_ns;
      wall_offset_ns = offset_ns;
    }
    if (running_) tick(slot, late_ns);
  }
}

void RealtimeLoop::runSimulated() {
  waitForClock();
  std::int64_t before_ns = toNs(clock_.rosNow());
  first_stamp_ns_ = before_ns;
  first_due_ns_ = before_ns;
  std::int64_t slot = 0;
  while (running_) {
    const std::int64_t now_ns = toNs(clock_.rosNow());
    if (now_ns < before_ns) {
      // The numbers go on, their stamps follow the new time.
      first_stamp_ns_ = now_ns - slot * period_ns_;
      first_due_ns_ = now_ns - slot * period_ns_;
      time_jumped_ = true;
    }
    before_ns = now_ns;
    const std::int64_t elapsed_ns = now_ns - first_stamp_ns_;
    if (elapsed_ns < slot * period_ns_) {
      callbacks_.idle();
      clock_.sleepUntil(clock_.steadyNow_ns() + kClockPoll_ns);
      continue;
    }
    const std::int64_t late_ns = elapsed_ns - slot * period_ns_;
    slot = std::max(slot, elapsed_ns / period_ns_);
    tick(slot, late_ns);
    ++slot;
  }
}

void RealtimeLoop::waitForClock() {
  waits_for_clock_ = true;
  while (running_ && clock_.rosNow().isZero()) {
    callbacks_.idle();
    clock_.sleepUntil(clock_.steadyNow_ns() + kClockPoll_ns);
  }
  waits_for_clock_ = false;
}

void RealtimeLoop::tick(std::int64_t slot, std::int64_t late_ns) {
  if (ticks_ > 0) skipped_ += static_cast<std::uint64_t>(slot - last_slot_ - 1);
  last_slot_ = slot;
  ++ticks_;
  sum_late_ns_ += late_ns;
  if (late_ns > largest_late_ns_) largest_late_ns_ = late_ns;
  callbacks_.tick(slot, stamp(slot));
}

}  // namespace hexapod
