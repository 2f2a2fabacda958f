#include "execution/source_clock.h"

#include <algorithm>
#include <cstdlib>

namespace hexapod {

bool SourceClock::isFresh(std::int64_t stamp_ns, const Arrival& arrival) {
  const std::int64_t offset_ns = arrival.steady_ns - stamp_ns;
  if (known_ && std::abs(offset_ns - steady_from_stamp_ns_) <= tolerance_ns_) {
    steady_from_stamp_ns_ = std::min(steady_from_stamp_ns_, offset_ns);
    return true;
  }
  if (std::abs(arrival.ros_ns - stamp_ns) > tolerance_ns_) return false;
  known_ = true;
  steady_from_stamp_ns_ = offset_ns;
  return true;
}

}  // namespace hexapod
