#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace hexapod {

/// Applies stamped commands a fixed latency after their stamp, on a grid of steps.
///
/// As long as commands arrive within the latency, jitter of transport and threads leaves no trace:
/// the step a command acts from depends on its stamp alone. All times are integer nanoseconds on
/// one axis. One owner; not thread-safe.
class CommandSchedule {
 public:
  enum class Arrival {
    kScheduled,
    kLate,     ///< the step it should act from has begun: acts from the next one
    kForeign,  ///< stamped more than a second from now, by another clock: acts from the next step
    kOld,      ///< older than a command that already acts: dropped
    kFull      ///< too many wait: dropped
  };

  explicit CommandSchedule(std::int64_t latency_ns) : latency_ns_(latency_ns) {}

  /// `last_step_ns` is when the last step taken began. A stamp of 0 acts from the next step on.
  Arrival add(std::int64_t stamp_ns, std::int64_t last_step_ns,
              const std::vector<double>& targets_rad);

  /// The newest command due at the step that begins at `step_ns`, nullptr when none became due.
  /// Valid until the next call of any function.
  const std::vector<double>* due(std::int64_t step_ns);

  /// Forgets what waits and what acts. The stream goes on: its newest stamp stays known.
  void clear();

  std::size_t waiting() const { return waiting_.size(); }
  /// Stamp of the newest command received, 0 when there is none.
  std::int64_t newestStamp_ns() const { return newest_stamp_ns_; }

 private:
  std::int64_t latency_ns_;
  std::map<std::int64_t, std::vector<double>> waiting_;  // by the time they act from
  std::vector<double> acting_;
  std::int64_t acting_since_ns_ = 0;
  std::int64_t newest_stamp_ns_ = 0;
};

}  // namespace hexapod
