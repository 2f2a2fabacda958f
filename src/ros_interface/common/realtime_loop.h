#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <thread>

#include "ros_interface/common/clock.h"

namespace hexapod {

/// How punctual a loop was.
struct LoopTiming {
  std::uint64_t ticks = 0;
  std::uint64_t skipped = 0;  ///< deadlines left out because the loop was more than a period late
  double largest_lateness_s = 0;  ///< of a tick against the deadline that was its turn
  double mean_lateness_s = 0;
};

/// A thread that ticks at absolute deadlines, exactly one period apart, numbered without gaps.
///
/// Deadlines are those of CLOCK_MONOTONIC, so that neither jitter accumulates nor a change of the
/// wall clock matters; with /use_sim_time they follow ROS time instead. A loop that is more than a
/// period late skips, it never catches up with a burst. The stamp of a deadline is on the ROS time
/// axis and its neighbours' are one period apart to the nanosecond.
class RealtimeLoop {
 public:
  struct Callbacks {
    /// One tick; runs in the loop's thread. Slots grow; missing ones were skipped.
    std::function<void(std::int64_t slot, const ros::Time& stamp)> tick;
    /// In the loop's thread, often, while simulated time does not bring the next deadline.
    std::function<void()> idle;
    /// In the loop's thread: may the stamps be moved when the wall clock was set? Not while
    /// somebody relies on their distance.
    std::function<bool()> may_move_stamps;
  };

  struct Options {
    std::int64_t period_ns = 0;
    bool realtime = true;  ///< ask for a real-time priority, and go on without
  };

  /// `clock` must outlive it.
  RealtimeLoop(const Options& options, const Clock& clock, Callbacks callbacks);
  /// Stops.
  ~RealtimeLoop();
  RealtimeLoop(const RealtimeLoop&) = delete;
  RealtimeLoop& operator=(const RealtimeLoop&) = delete;

  void start();
  /// Waits for the tick under way; none follows.
  void stop();

  /// From any thread.
  /// @{
  ros::Time stamp(std::int64_t slot) const;
  /// When a slot is due, on Clock::robotNow_ns().
  std::int64_t due_ns(std::int64_t slot) const { return first_due_ns_ + slot * period_ns_; }
  LoopTiming timing() const;
  /// True while /use_sim_time is set and no /clock has come.
  bool waitsForClock() const { return waits_for_clock_; }
  /// True once after each time ROS time jumped back.
  bool takeTimeJump() { return time_jumped_.exchange(false); }
  /// 0: the loop has a real-time priority; else the errno of the refusal, -1 when not asked (yet).
  int realtimeRefusal() const { return realtime_refusal_; }
  /// @}

 private:
  void run();
  void runSteady();
  void runSimulated();
  void waitForClock();
  std::int64_t wallFromSteady_ns() const;
  void tick(std::int64_t slot, std::int64_t late_ns);

  Options options_;
  std::int64_t period_ns_;
  const Clock& clock_;
  Callbacks callbacks_;
  std::thread thread_;
  std::atomic<bool> running_{false};
  std::atomic<std::int64_t> first_stamp_ns_{0};  // of slot 0
  std::atomic<std::int64_t> first_due_ns_{0};    // slot 0
  std::int64_t last_slot_ = -1;
  std::atomic<bool> waits_for_clock_{false};
  std::atomic<bool> time_jumped_{false};
  std::atomic<int> realtime_refusal_{-1};
  std::atomic<std::uint64_t> ticks_{0};
  std::atomic<std::uint64_t> skipped_{0};
  std::atomic<std::int64_t> largest_late_ns_{0};
  std::atomic<std::int64_t> sum_late_ns_{0};
};

}  // namespace hexapod
