#pragma once

#include <cstdint>

#include "ros_interface/common/clock.h"

namespace hexapod {

/// How long to wait for something that takes its time on the robot's clock, which may be simulated:
/// slow, fast, set, or standing still. A jump of it counts for little, and once it stands the wait
/// is over in 1.5 s of steady time. Used by one thread.
class Patience {
 public:
  enum class Verdict { kWait, kTooLong, kTimeStands };

  /// `limit_s`: in the robot's time, since the last sign of life. The clock must outlive it.
  Patience(const Clock& clock, double limit_s);

  /// A sign of life: the wait begins anew.
  void renew();

  /// To be asked at least some times a second.
  Verdict verdict();

 private:
  const Clock& clock_;
  double limit_s_;
  double passed_s_ = 0.0;  // in the robot's time
  std::int64_t asked_ns_;  // steady
  std::int64_t moved_ns_;  // steady; when the robot's time was last seen to go on
  ros::Time time_;
};

}  // namespace hexapod
