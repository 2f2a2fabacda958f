#include "ros_interface/common/realtime_loop.h"

#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <cstdlib>

namespace hexapod {
namespace {

// Above the kernel's ordinary threads, below its interrupt threads (50).
constexpr int kFifoPriority = 40;
// A wall clock is taken for set, not slewed, beyond this.
constexpr std::int64_t kClockSet_ns = 20'000'000;
constexpr std::int64_t kClockPoll_ns = 300'000;

bool askForRealtimePriority() {
  sched_param parameters{};
  parameters.sched_priority = kFifoPriority;
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0;
}

// ROS wall time at the steady time 0 [ns]. The reading with the shortest gap between two looks at
// the steady clock is the one nobody interrupted.
std::int64_t wallFromSteady_ns() {
  std::int64_t best_gap_ns = kSecond_ns;
  std::int64_t best_ns = 0;
  for (int i = 0; i < 3; ++i) {
    const std::int64_t before_ns = steadyNow_ns();
    const ros::WallTime wall = ros::WallTime::now();
    const std::int64_t gap_ns = steadyNow_ns() - before_ns;
    if (gap_ns >= best_gap_ns) continue;
    best_gap_ns = gap_ns;
    best_ns = static_cast<std::int64_t>(wall.toNSec()) - before_ns - gap_ns / 2;
  }
  return best_ns;
}

}  // namespace

RealtimeLoop::RealtimeLoop(std::int64_t period_ns, Callbacks callbacks)
    : period_ns_(period_ns), callbacks_(std::move(callbacks)) {}

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
  realtime_priority_ = askForRealtimePriority();
  ros::Time::isSimTime() ? runSimulated() : runSteady();
}

void RealtimeLoop::runSteady() {
  const std::int64_t start_ns = steadyNow_ns();
  std::int64_t wall_offset_ns = wallFromSteady_ns();
  first_stamp_ns_ = start_ns + wall_offset_ns;
  for (std::int64_t slot = 0; running_; ++slot) {
    sleepUntilSteady(start_ns + slot * period_ns_);
    const std::int64_t elapsed_ns = steadyNow_ns() - start_ns;
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
  std::int64_t before_ns = toNs(ros::Time::now());
  first_stamp_ns_ = before_ns;
  std::int64_t slot = 0;
  while (running_) {
    const std::int64_t now_ns = toNs(ros::Time::now());
    if (now_ns < before_ns) {
      // The numbers go on, their stamps follow the new time.
      first_stamp_ns_ = now_ns - slot * period_ns_;
      time_jumped_ = true;
    }
    before_ns = now_ns;
    const std::int64_t elapsed_ns = now_ns - first_stamp_ns_;
    if (elapsed_ns < slot * period_ns_) {
      callbacks_.idle();
      sleepUntilSteady(steadyNow_ns() + kClockPoll_ns);
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
  while (running_ && ros::Time::now().isZero()) {
    callbacks_.idle();
    sleepUntilSteady(steadyNow_ns() + kClockPoll_ns);
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
