#pragma once

#include <algorithm>
#include <cstdint>

#include "ros_interface/common/clock.h"

namespace hexapod {

/// How long nothing has come from somebody who was listened for. From one look to the next at most
/// a tenth of a second counts: while this process did not run itself, on a busy machine or stopped
/// by hand, what came waits to be heard, and its own silence is nobody else's. To be looked at some
/// times a second. Used by one thread, or under its owner's lock.
class Silence {
 public:
  /// Begins now. The clock must outlive it.
  explicit Silence(const Clock& clock) : clock_(clock), looked_ns_(clock.steadyNow_ns()) {}

  /// Something came.
  void end() {
    look_ns();
    silent_ns_ = 0;
  }

  /// For how long nothing came [ns, steady time].
  std::int64_t look_ns() {
    const std::int64_t now_ns = clock_.steadyNow_ns();
    silent_ns_ += std::min(now_ns - looked_ns_, kMostAtOnce_ns);
    looked_ns_ = now_ns;
    return silent_ns_;
  }

 private:
  static constexpr std::int64_t kMostAtOnce_ns = kSecond_ns / 10;

  const Clock& clock_;
  std::int64_t looked_ns_;
  std::int64_t silent_ns_ = 0;
};

}  // namespace hexapod
