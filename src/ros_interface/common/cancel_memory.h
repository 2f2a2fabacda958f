#pragma once

#include <ros/time.h>

#include <cstdint>
#include <mutex>

#include "ros_interface/common/clock.h"

namespace hexapod {

/// When all goals were last cancelled. Goals and cancels come by different connections, and one
/// that was sent first may come last: it is cancelled all the same. Of no use in simulated time,
/// which is coarse and comes to one node later than to another. From any thread.
class CancelMemory {
 public:
  void cancelAll(const ros::Time& now, std::int64_t steady_ns) {
    const std::lock_guard<std::mutex> lock(mutex_);
    cancelled_ = now;
    cancelled_ns_ = steady_ns;
  }

  /// Of a goal that has just come, and was sent at `sent` by the client's clock; zero: nobody
  /// knows. For a tenth of a second only, since that clock may be another one.
  bool covers(const ros::Time& sent, std::int64_t steady_ns) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return !cancelled_.isZero() && !sent.isZero() && sent < cancelled_ &&
           steady_ns - cancelled_ns_ < kSecond_ns / 10;
  }

 private:
  mutable std::mutex mutex_;
  ros::Time cancelled_;            // guarded by mutex_
  std::int64_t cancelled_ns_ = 0;  // guarded by mutex_
};

}  // namespace hexapod
