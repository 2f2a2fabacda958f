#pragma once

#include <ros/time.h>

#include <cstdint>
#include <functional>

namespace hexapod {

/// The two times of a node, behind one interface so that a test can hold both.
///
/// Periods, ages and timeouts are measured on the steady time, which nobody sets, stops or turns
/// back. ROS time is for stamps and tf alone: it is the wall clock, which may be set at any moment,
/// or simulated time, which may stand still, jump or never begin. From any thread.
class Clock {
 public:
  virtual ~Clock() = default;

  /// Steady time [ns] since an arbitrary moment.
  virtual std::int64_t steadyNow_ns() const = 0;

  /// ROS time; zero while simulated time has not begun.
  virtual ros::Time rosNow() const = 0;

  /// Waits until `done` is true (asked every few milliseconds) or steady time has come to
  /// `deadline_ns`. Returns what `done` said last.
  virtual bool waitUntil(std::int64_t deadline_ns, const std::function<bool()>& done) const = 0;

  /// Sleeps until steady time has come to `deadline_ns`, to the precision of the system.
  virtual void sleepUntil(std::int64_t deadline_ns) const {
    waitUntil(deadline_ns, [] { return false; });
  }

  /// True when ROS time is simulated.
  virtual bool isSimulated() const { return false; }

  /// What the robot lives in [ns], for how long something took it: simulated time where there is
  /// such, else steady time.
  std::int64_t robotNow_ns() const;
};

/// CLOCK_MONOTONIC and ros::Time.
class SystemClock : public Clock {
 public:
  std::int64_t steadyNow_ns() const override;
  ros::Time rosNow() const override;
  bool waitUntil(std::int64_t deadline_ns, const std::function<bool()>& done) const override;
  void sleepUntil(std::int64_t deadline_ns) const override;
  bool isSimulated() const override;
};

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::int64_t kMillisecond_ns = 1'000'000;

/// Seconds to nanoseconds, rounded to the nearest.
std::int64_t secondsToNs(double seconds);

/// CLOCK_MONOTONIC [ns].
std::int64_t steadyNow_ns();
/// Sleeps until CLOCK_MONOTONIC is at `deadline_ns`.
void sleepUntilSteady(std::int64_t deadline_ns);

ros::Time timeFromNs(std::int64_t ns);
std::int64_t toNs(const ros::Time& time);

}  // namespace hexapod
