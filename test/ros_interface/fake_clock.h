#pragma once

#include <ros/time.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <mutex>

#include "ros_interface/common/clock.h"

namespace hexapod {

/// A clock that a test holds: waits take no time. Waiting moves both times on in steps of 5 ms, ROS
/// time by `rate` times as much, and calls `on_step` in between. From any thread.
class FakeClock : public Clock {
 public:
  std::int64_t steadyNow_ns() const override {
    const std::lock_guard<std::mutex> lock(mutex_);
    return steady_ns_;
  }

  ros::Time rosNow() const override {
    const std::lock_guard<std::mutex> lock(mutex_);
    return ros_;
  }

  bool waitUntil(std::int64_t deadline_ns, const std::function<bool()>& done) const override {
    while (!done()) {
      const std::int64_t left_ns = deadline_ns - steadyNow_ns();
      if (left_ns <= 0) return false;
      pass(std::min(left_ns, kStep_ns));
    }
    return true;
  }

  /// Lets time pass.
  void pass(std::int64_t ns) const {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      steady_ns_ += ns;
      ros_ += ros::Duration(1e-9 * rate_ * static_cast<double>(ns));
    }
    if (on_step) on_step();
  }

  /// Sets ROS time, as somebody sets a wall clock.
  void setRos(double seconds) {
    const std::lock_guard<std::mutex> lock(mutex_);
    ros_ = ros::Time(seconds);
  }

  /// How fast ROS time goes from now on; 0: it stands.
  void setRate(double rate) {
    const std::lock_guard<std::mutex> lock(mutex_);
    rate_ = rate;
  }

  std::function<void()> on_step;

 private:
  static constexpr std::int64_t kStep_ns = 5'000'000;

  mutable std::mutex mutex_;
  mutable std::int64_t steady_ns_ = kSecond_ns;
  mutable ros::Time ros_{1000.0};
  double rate_ = 1.0;
};

}  // namespace hexapod
