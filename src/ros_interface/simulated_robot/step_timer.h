#pragma once

#include <cstdint>

#include "ros_interface/common/clock.h"

namespace hexapod {

/// When the steps of a simulated world are due, and what time it is there.
///
/// Its time is begin + n * step in integer nanoseconds and never goes back. At a factor other than
/// 0 a step is due when it ends on steady time; at 0 every step is due at once. Steps that a short
/// stall of the process missed are due at once; what cannot be made up for so, the world has stood
/// still: a world that owns the clock (publish_clock) stops time for everybody, another one goes on
/// where time is by now. Used by one thread.
class StepTimer {
 public:
  struct Options {
    std::int64_t step_ns = 0;
    double factor = 1.0;      ///< how fast its time goes; 0: as fast as it can
    bool owns_clock = false;  ///< others follow its time
  };

  /// The clock must outlive it.
  StepTimer(const Options& options, const Clock& clock);

  /// Its time begins now, with `time_ns`.
  void begin(std::int64_t time_ns);

  /// Of the world's state.
  std::int64_t time_ns() const { return time_ns_; }

  /// How long until the next step is due [ns, steady]; 0 or less: it is, and is so late.
  std::int64_t wait_ns() const;

  /// A step that is so late was missed by a process that stalled.
  bool isStall(std::int64_t late_ns) const;
  /// Leaves out what steps that are due cannot make up for. Returns for how long others saw the
  /// world stand still [ns].
  std::int64_t standStill(std::int64_t late_ns);

  /// The step that was due is taken.
  void step();

  /// A world that owns the clock stops time while it is paused.
  void pause(bool paused);
  bool isPaused() const { return paused_; }

 private:
  Options options_;
  const Clock& clock_;
  std::int64_t begin_ns_;     // steady, when the first step begins
  std::int64_t time_ns_ = 0;  // of the world's state
  std::int64_t steps_ = 0;    // since begin_ns_
  bool paused_ = false;
};

}  // namespace hexapod
