#include "ros_interface/robot_client/patience.h"

#include <algorithm>

namespace hexapod {
namespace {

// A simulator that publishes /clock at all does so more often.
constexpr std::int64_t kFrozen_ns = 3 * kSecond_ns / 2;
// What it gains beyond this from one question to the next, it was set by.
constexpr double kMostAtOnce_s = 1.0;

}  // namespace

Patience::Patience(const Clock& clock, double limit_s)
    : clock_(clock),
      limit_s_(limit_s),
      asked_ns_(clock.steadyNow_ns()),
      moved_ns_(asked_ns_),
      time_(clock.rosNow()) {}

void Patience::renew() { passed_s_ = 0.0; }

Patience::Verdict Patience::verdict() {
  const std::int64_t now_ns = clock_.steadyNow_ns();
  const ros::Time time = clock_.rosNow();
  const double steady_s = 1e-9 * static_cast<double>(now_ns - asked_ns_);
  const double gained_s = (time - time_).toSec();
  if (time != time_) {
    moved_ns_ = now_ns;
    passed_s_ += std::min(gained_s < 0.0 ? steady_s : gained_s, kMostAtOnce_s);
  }
  asked_ns_ = now_ns;
  time_ = time;
  if (passed_s_ > limit_s_) return Verdict::kTooLong;
  return now_ns - moved_ns_ > kFrozen_ns ? Verdict::kTimeStands : Verdict::kWait;
}

}  // namespace hexapod
