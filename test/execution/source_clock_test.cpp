#include "execution/source_clock.h"

#include <gtest/gtest.h>

#include "ms.h"

namespace hexapod {
namespace {

constexpr std::int64_t kHour = 3'600'000 * kMs;
// Our clocks when the session begins.
constexpr std::int64_t kRos = 1'700'000'000'000 * kMs;
constexpr std::int64_t kSteady = 5'000 * kMs;

Arrival at(std::int64_t ms, std::int64_t ros_set_ns = 0) {
  return {kRos + ms * kMs + ros_set_ns, kSteady + ms * kMs};
}
std::int64_t stamp(std::int64_t ms) { return kRos + ms * kMs; }

TEST(SourceClock, BelievesStampsThatAreAsOldAsTransportMakesThem) {
  SourceClock clock(500 * kMs);
  for (const std::int64_t delay : {0, 3, 200, 499}) {
    EXPECT_TRUE(clock.isFresh(stamp(1000), at(1000 + delay))) << delay;
  }
}

TEST(SourceClock, DoesNotBelieveWhatWaitedOrWasRecordedOrComesFromAnotherClock) {
  SourceClock clock(500 * kMs);
  EXPECT_FALSE(clock.isFresh(stamp(0), at(501))) << "waited in a queue";
  EXPECT_FALSE(clock.isFresh(stamp(0) - kHour, at(0))) << "recorded";
  EXPECT_FALSE(clock.isFresh(stamp(0) + kHour, at(0))) << "another clock";
  EXPECT_TRUE(clock.isFresh(stamp(1000), at(1001)));
  EXPECT_FALSE(clock.isFresh(stamp(1010), at(1800))) << "waited, by both times";
}

TEST(SourceClock, GoesOnBelievingWhenAClockIsSet) {
  for (const std::int64_t set : {kHour, -kHour}) {
    SourceClock ours(500 * kMs);
    ASSERT_TRUE(ours.isFresh(stamp(0), at(1)));
    EXPECT_TRUE(ours.isFresh(stamp(10), at(11, set))) << "ours was set, the driver's was not";
    EXPECT_FALSE(ours.isFresh(stamp(20), at(900, set)));
    SourceClock both(500 * kMs);
    ASSERT_TRUE(both.isFresh(stamp(0), at(1)));
    EXPECT_TRUE(both.isFresh(stamp(10) + set, at(11, set))) << "one machine, one clock";
    EXPECT_TRUE(both.isFresh(stamp(20) + set, at(21, set)));
    EXPECT_FALSE(both.isFresh(stamp(30), at(31, set))) << "the clock before is no clock any more";
  }
}

TEST(SourceClock, ADelayThatGrowsBitByBitIsADelay) {
  SourceClock clock(500 * kMs);
  std::int64_t delay = 0;
  while (delay < 5000 && clock.isFresh(stamp(delay), at(delay + delay))) delay += 10;
  EXPECT_EQ(delay, 510);
}

}  // namespace
}  // namespace hexapod
