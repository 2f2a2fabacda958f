#include "ros_interface/common/clock.h"

#include <time.h>

#include <algorithm>
#include <cerrno>
#include <cmath>

namespace hexapod {
namespace {

constexpr std::int64_t kPoll_ns = 5'000'000;

}  // namespace

std::int64_t Clock::robotNow_ns() const { return isSimulated() ? toNs(rosNow()) : steadyNow_ns(); }

std::int64_t SystemClock::steadyNow_ns() const { return hexapod::steadyNow_ns(); }

ros::Time SystemClock::rosNow() const { return ros::Time::now(); }

bool SystemClock::waitUntil(std::int64_t deadline_ns, const std::function<bool()>& done) const {
  while (!done()) {
    const std::int64_t now_ns = steadyNow_ns();
    if (now_ns >= deadline_ns) return false;
    sleepUntilSteady(std::min(deadline_ns, now_ns + kPoll_ns));
  }
  return true;
}

void SystemClock::sleepUntil(std::int64_t deadline_ns) const { sleepUntilSteady(deadline_ns); }

bool SystemClock::isSimulated() const { return ros::Time::isSimTime(); }

std::int64_t secondsToNs(double seconds) {
  return static_cast<std::int64_t>(std::llround(seconds * static_cast<double>(kSecond_ns)));
}

std::int64_t steadyNow_ns() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::int64_t>(now.tv_sec) * kSecond_ns + now.tv_nsec;
}

void sleepUntilSteady(std::int64_t deadline_ns) {
  timespec deadline{};
  deadline.tv_sec = static_cast<time_t>(deadline_ns / kSecond_ns);
  deadline.tv_nsec = static_cast<long>(deadline_ns % kSecond_ns);
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &deadline, nullptr) == EINTR) {
  }
}

ros::Time timeFromNs(std::int64_t ns) {
  ros::Time time;
  return time.fromNSec(static_cast<std::uint64_t>(ns));
}

std::int64_t toNs(const ros::Time& time) { return static_cast<std::int64_t>(time.toNSec()); }

}  // namespace hexapod
