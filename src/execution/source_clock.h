#pragma once

#include <cstdint>

namespace hexapod {

/// When a message came, on both times of a node.
struct Arrival {
  std::int64_t ros_ns = 0;     ///< ROS time, which may be set at any moment
  std::int64_t steady_ns = 0;  ///< time nobody sets; with simulated time that time
};

/// Judges the stamps of one source of messages: are they as old as they should be?
///
/// A stamp is fresh when ROS time says so, or when the source's clock has gone on as our steady
/// time has since its last fresh stamp. So neither a clock that is set on either side nor one set
/// on both makes fresh messages old, while what waited in a queue, was recorded, or comes from a
/// clock that was never ours is not believed. Not thread-safe.
class SourceClock {
 public:
  explicit SourceClock(std::int64_t tolerance_ns) : tolerance_ns_(tolerance_ns) {}

  bool isFresh(std::int64_t stamp_ns, const Arrival& arrival);

  /// Of a fresh stamp, just asked about: what it says on steady time. Not after its arrival.
  std::int64_t steady_ns(std::int64_t stamp_ns) const { return stamp_ns + steady_from_stamp_ns_; }

 private:
  std::int64_t tolerance_ns_;
  bool known_ = false;
  std::int64_t steady_from_stamp_ns_ = 0;  // the least delay since the source's clock was set
};

}  // namespace hexapod
