#include "ros_interface/simulated_robot/step_timer.h"

#include <gtest/gtest.h>

#include "ros_interface/fake_clock.h"

namespace hexapod {
namespace {

constexpr std::int64_t kStep = 15 * kMillisecond_ns;
constexpr std::int64_t kBegin = 1'700'000'000 * kSecond_ns;

// A timer whose time has begun, and a process that takes every step that is due.
class StepTimerTest : public testing::Test {
 protected:
  StepTimer timer(double factor, bool owns_clock) {
    StepTimer timer({kStep, factor, owns_clock}, clock_);
    timer.begin(kBegin);
    return timer;
  }
  static std::int64_t takeDueSteps(StepTimer& timer) {
    std::int64_t steps = 0;
    for (; timer.wait_ns() <= 0; ++steps) timer.step();
    return steps;
  }

  FakeClock clock_;
};

TEST_F(StepTimerTest, AStepIsDueWhenItEnds) {
  StepTimer timer = this->timer(1.0, false);
  EXPECT_EQ(timer.wait_ns(), kStep);
  clock_.pass(kStep - 1);
  EXPECT_EQ(timer.wait_ns(), 1);
  clock_.pass(1);
  EXPECT_EQ(takeDueSteps(timer), 1);
  EXPECT_EQ(timer.time_ns(), kBegin + kStep);
}

TEST_F(StepTimerTest, TimeGoesByItsFactorWithoutDrift) {
  for (const double factor : {0.3, 1.0, 4.0}) {
    StepTimer timer = this->timer(factor, true);
    std::int64_t steps = 0;
    for (int i = 0; i < 1000; ++i) {
      clock_.pass(7 * kMillisecond_ns);
      steps += takeDueSteps(timer);
    }
    EXPECT_EQ(steps, static_cast<std::int64_t>(7000.0 * factor / 15.0)) << factor;
    EXPECT_EQ(timer.time_ns(), kBegin + steps * kStep);
  }
}

TEST_F(StepTimerTest, AtFactorZeroEveryStepIsDueAndNothingIsAStall) {
  StepTimer timer = this->timer(0.0, true);
  for (int i = 0; i < 100; ++i) {
    EXPECT_LE(timer.wait_ns(), 0);
    timer.step();
  }
  EXPECT_FALSE(timer.isStall(3600 * kSecond_ns));
  EXPECT_EQ(timer.standStill(3600 * kSecond_ns), 0);
  EXPECT_EQ(timer.time_ns(), kBegin + 100 * kStep);
}

TEST_F(StepTimerTest, AShortStallIsMadeUpFor) {
  StepTimer timer = this->timer(1.0, false);
  clock_.pass(200 * kMillisecond_ns);
  const std::int64_t late_ns = -timer.wait_ns();
  EXPECT_EQ(late_ns, 185 * kMillisecond_ns);
  EXPECT_TRUE(timer.isStall(late_ns));
  EXPECT_EQ(timer.standStill(late_ns), 0);
  EXPECT_EQ(takeDueSteps(timer), 13);  // 195 ms
}

TEST_F(StepTimerTest, AfterALongOneTheWorldHasStoodStillAndItsTimeIsThatOfTheOthers) {
  StepTimer timer = this->timer(1.0, false);
  clock_.pass(5 * kSecond_ns);
  EXPECT_EQ(timer.standStill(-timer.wait_ns()), 332 * kStep);  // 4.985 s, in whole steps
  EXPECT_EQ(takeDueSteps(timer), 1);
  EXPECT_LE(kBegin + 5 * kSecond_ns - timer.time_ns(), kStep);
}

TEST_F(StepTimerTest, AStallOfAWorldThatOwnsTheClockStopsTimeForAll) {
  StepTimer timer = this->timer(1.0, true);
  clock_.pass(5 * kSecond_ns);
  EXPECT_EQ(timer.standStill(-timer.wait_ns()), 0);
  EXPECT_EQ(takeDueSteps(timer), 1);
  EXPECT_EQ(timer.time_ns(), kBegin + kStep);
}

TEST_F(StepTimerTest, APauseStopsTheTimeOfAWorldThatOwnsItAndOnlyThat) {
  for (const bool owns_clock : {true, false}) {
    StepTimer timer = this->timer(1.0, owns_clock);
    timer.pause(true);
    EXPECT_TRUE(timer.isPaused());
    clock_.pass(10 * kStep);
    EXPECT_EQ(timer.wait_ns() > 0, owns_clock);
    EXPECT_EQ(takeDueSteps(timer), owns_clock ? 0 : 10);
    timer.pause(false);
    EXPECT_EQ(timer.wait_ns(), kStep);
  }
}

}  // namespace
}  // namespace hexapod
