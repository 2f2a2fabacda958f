#include "ros_interface/common/clock.h"

#include <gtest/gtest.h>

namespace hexapod {
namespace {

TEST(Clock, SecondsAndRosTimesAreExactNanoseconds) {
  EXPECT_EQ(secondsToNs(0.030), 30'000'000);
  EXPECT_EQ(secondsToNs(-1.5), -1'500'000'000);
  EXPECT_EQ(secondsToNs(3e-10), 0);
  for (const std::int64_t ns : {std::int64_t{0}, std::int64_t{1'700'000'000'123'456'789}}) {
    EXPECT_EQ(toNs(timeFromNs(ns)), ns);
  }
}

TEST(Clock, SteadyTimeGoesOnAndWaitsEndAtTheirDeadlineOrBefore) {
  const SystemClock clock;
  const std::int64_t start_ns = clock.steadyNow_ns();
  EXPECT_FALSE(clock.waitUntil(start_ns - 1, [] { return false; })) << "a deadline that is past";
  EXPECT_TRUE(clock.waitUntil(start_ns - 1, [] { return true; }));
  int asked = 0;
  EXPECT_TRUE(clock.waitUntil(start_ns + 3600 * kSecond_ns, [&] { return ++asked == 3; }));
  clock.sleepUntil(start_ns + 1'000'000);
  EXPECT_GE(clock.steadyNow_ns(), start_ns + 1'000'000);
}

}  // namespace
}  // namespace hexapod
