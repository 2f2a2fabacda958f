#include "ros_interface/simulated_robot/step_timer.h"

namespace hexapod {
namespace {

constexpr std::int64_t kStall_ns = 30 * kMillisecond_ns;
// Later than this, the world has stood still instead: an executor takes joint states that are half
// a second old for those of a robot that is gone.
constexpr std::int64_t kLongestCatchUp_ns = 300 * kMillisecond_ns;
// While time stands.
constexpr std::int64_t kLook_ns = 50 * kMillisecond_ns;

}  // namespace

StepTimer::StepTimer(const Options& options, const Clock& clock)
    : options_(options), clock_(clock), begin_ns_(clock.steadyNow_ns()) {}

void StepTimer::begin(std::int64_t time_ns) {
  begin_ns_ = clock_.steadyNow_ns();
  time_ns_ = time_ns;
  steps_ = 0;
}

std::int64_t StepTimer::wait_ns() const {
  if (paused_ && options_.owns_clock) return kLook_ns;
  if (options_.factor == 0.0) return 0;
  const double elapsed_ns = static_cast<double>((steps_ + 1) * options_.step_ns) / options_.factor;
  return begin_ns_ + static_cast<std::int64_t>(elapsed_ns) - clock_.steadyNow_ns();
}

bool StepTimer::isStall(std::int64_t late_ns) const {
  return options_.factor != 0.0 && late_ns >= kStall_ns;
}

std::int64_t StepTimer::standStill(std::int64_t late_ns) {
  if (!isStall(late_ns)) return 0;
  if (options_.owns_clock) {
    begin_ns_ += late_ns;
    return 0;
  }
  if (late_ns < kLongestCatchUp_ns) return 0;
  const std::int64_t steps = late_ns / options_.step_ns;
  steps_ += steps;
  time_ns_ += steps * options_.step_ns;
  return steps * options_.step_ns;
}

void StepTimer::step() {
  ++steps_;
  time_ns_ += options_.step_ns;
}

void StepTimer::pause(bool paused) {
  if (paused_ && !paused && options_.owns_clock) {
    // The next step is due one step from now.
    begin_ns_ = clock_.steadyNow_ns();
    steps_ = 0;
  }
  paused_ = paused;
}

}  // namespace hexapod
