#include "ros_interface/common/realtime_loop.h"

#include <gtest/gtest.h>

#include <future>
#include <vector>

#include "ros_interface/fake_clock.h"

namespace hexapod {
namespace {

constexpr std::int64_t kPeriod = 30 * kMillisecond_ns;

class SimulatedTime : public FakeClock {
 public:
  bool isSimulated() const override { return true; }
};

// Runs a loop on a clock that a test holds, for some ticks; what the test does in a tick happens
// there. No time passes but on that clock.
template <typename AnyClock>
class LoopRun {
 public:
  struct Tick {
    std::int64_t slot;
    std::int64_t stamp_ns;
    std::int64_t steady_ns;
  };

  std::function<void(std::int64_t slot)> in_tick = [](std::int64_t) {};
  std::function<void()> in_idle = [] {};
  bool may_move_stamps = true;
  AnyClock clock;

  std::vector<Tick> run(std::size_t count) {
    std::promise<void> done;
    std::vector<Tick> ticks;
    RealtimeLoop::Callbacks callbacks;
    callbacks.tick = [&](std::int64_t slot, const ros::Time& stamp) {
      if (ticks.size() == count) return;
      ticks.push_back({slot, toNs(stamp), clock.steadyNow_ns()});
      in_tick(slot);
      if (ticks.size() < count) return;
      timing = loop->timing();
      time_jumped = loop->takeTimeJump();
      done.set_value();
    };
    callbacks.idle = [this] { in_idle(); };
    callbacks.may_move_stamps = [this] { return may_move_stamps; };
    loop = std::make_unique<RealtimeLoop>(RealtimeLoop::Options{kPeriod, false}, clock, callbacks);
    loop->start();
    done.get_future().wait();
    loop->stop();
    return ticks;
  }

  std::unique_ptr<RealtimeLoop> loop;
  LoopTiming timing;
  bool time_jumped = false;
};

TEST(RealtimeLoop, TicksAtEveryDeadlineWithStampsOnePeriodApart) {
  LoopRun<FakeClock> run;
  run.in_tick = [&](std::int64_t slot) { run.clock.pass(slot % 3 * 7 * kMillisecond_ns); };
  const auto ticks = run.run(50);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    EXPECT_EQ(ticks[i].slot, static_cast<std::int64_t>(i));
    EXPECT_EQ(ticks[i].stamp_ns - ticks[0].stamp_ns, static_cast<std::int64_t>(i) * kPeriod);
    EXPECT_EQ(ticks[i].steady_ns - ticks[0].steady_ns, static_cast<std::int64_t>(i) * kPeriod)
        << "what a tick takes does not add up";
    EXPECT_EQ(run.loop->due_ns(ticks[i].slot), ticks[i].steady_ns);
  }
  EXPECT_EQ(run.timing.skipped, 0u);
  EXPECT_EQ(run.timing.largest_lateness_s, 0.0);
}

TEST(RealtimeLoop, AStallSkipsDeadlinesAndIsTheLargestLateness) {
  LoopRun<FakeClock> run;
  run.in_tick = [&](std::int64_t slot) {
    if (slot == 10) run.clock.pass(200 * kMillisecond_ns);
  };
  const auto ticks = run.run(15);
  // 200 ms after the deadline of slot 10 the one of slot 16 is 20 ms past; it was 11's turn.
  EXPECT_EQ(ticks[11].slot, 16);
  EXPECT_EQ(ticks[12].slot, 17) << "no burst";
  EXPECT_EQ(ticks[12].steady_ns - ticks[11].steady_ns, 10 * kMillisecond_ns)
      << "back on the timeline";
  EXPECT_EQ(run.timing.skipped, 5u);
  EXPECT_DOUBLE_EQ(run.timing.largest_lateness_s, 0.170);
}

TEST(RealtimeLoop, StampsFollowAWallClockThatIsSetButOnlyWhenTheyMay) {
  constexpr std::int64_t kHour = 3600 * kSecond_ns;
  LoopRun<FakeClock> run;
  run.in_tick = [&](std::int64_t slot) {
    if (slot == 4) run.clock.setRos(run.clock.rosNow().toSec() + 3600.0);
    run.may_move_stamps = slot < 3 || slot >= 9;
  };
  const auto ticks = run.run(20);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const std::int64_t moved = i >= 10 ? kHour : 0;
    EXPECT_NEAR(static_cast<double>(ticks[i].stamp_ns - ticks[0].stamp_ns -
                                    static_cast<std::int64_t>(i) * kPeriod - moved),
                0.0, 1e6)
        << i;
    EXPECT_EQ(ticks[i].slot, static_cast<std::int64_t>(i)) << "steady time was not set";
    EXPECT_EQ(run.loop->due_ns(ticks[i].slot), ticks[i].steady_ns);
  }
}

TEST(RealtimeLoop, OnSimulatedTimeWaitsForItThenFollowsIt) {
  LoopRun<SimulatedTime> run;
  run.clock.setRos(0.0);
  run.clock.setRate(0.0);
  int idle = 0;
  bool waited = false;
  run.in_idle = [&] {
    waited = waited || run.loop->waitsForClock();
    // Simulated time comes after a while, stands still until now and then it makes a step.
    if (++idle == 100) run.clock.setRos(500.0);
    if (idle > 100 && idle % 50 == 0) run.clock.setRos(run.clock.rosNow().toSec() + 0.030);
  };
  const auto ticks = run.run(5);
  EXPECT_TRUE(waited);
  EXPECT_EQ(ticks[0].stamp_ns, 500 * kSecond_ns);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    EXPECT_EQ(ticks[i].slot, static_cast<std::int64_t>(i));
  }
}

TEST(RealtimeLoop, SlotsGoOnWhenSimulatedTimeJumpsBack) {
  LoopRun<SimulatedTime> run;
  run.in_tick = [&](std::int64_t slot) {
    if (slot == 5) run.clock.setRos(3.0);
  };
  const auto ticks = run.run(10);
  EXPECT_TRUE(run.time_jumped);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    EXPECT_EQ(ticks[i].slot, static_cast<std::int64_t>(i));
  }
  EXPECT_EQ(ticks[6].stamp_ns, 3 * kSecond_ns);
  EXPECT_EQ(ticks[7].stamp_ns, 3 * kSecond_ns + kPeriod);
  EXPECT_EQ(run.loop->due_ns(7), 3 * kSecond_ns + kPeriod) << "simulated time is the robot's";
}

}  // namespace
}  // namespace hexapod
