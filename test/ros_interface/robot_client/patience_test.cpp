#include "ros_interface/robot_client/patience.h"

#include <gtest/gtest.h>

#include "ros_interface/fake_clock.h"

namespace hexapod {
namespace {

// Steady seconds until it waits no more, asked every 50 ms; 60 at most.
double waited_s(FakeClock& clock, Patience& patience, Patience::Verdict& verdict) {
  const std::int64_t start_ns = clock.steadyNow_ns();
  clock.waitUntil(start_ns + 60 * kSecond_ns, [&] {
    if ((clock.steadyNow_ns() - start_ns) % (kSecond_ns / 20) != 0) return false;
    verdict = patience.verdict();
    return verdict != Patience::Verdict::kWait;
  });
  return 1e-9 * static_cast<double>(clock.steadyNow_ns() - start_ns);
}

TEST(Patience, IsOverAfterItsLimitOfTheRobotsTime) {
  for (const double rate : {1.0, 0.2, 4.0}) {
    FakeClock clock;
    clock.setRate(rate);
    Patience patience(clock, 5.0);
    Patience::Verdict verdict = Patience::Verdict::kWait;
    EXPECT_NEAR(waited_s(clock, patience, verdict), 5.0 / rate, 0.1);
    EXPECT_EQ(verdict, Patience::Verdict::kTooLong);
  }
}

TEST(Patience, IsOverSoonOnceTimeStands) {
  FakeClock clock;
  Patience patience(clock, 5.0);
  clock.pass(kSecond_ns);
  EXPECT_EQ(patience.verdict(), Patience::Verdict::kWait);
  clock.setRate(0.0);
  Patience::Verdict verdict = Patience::Verdict::kWait;
  EXPECT_NEAR(waited_s(clock, patience, verdict), 1.5, 0.1);
  EXPECT_EQ(verdict, Patience::Verdict::kTimeStands);
}

TEST(Patience, IsNotFooledByAClockThatIsSet) {
  for (const double now_s : {4600.0, -2600.0 + 3600.0 - 999.0, 1.0e9}) {
    FakeClock clock;
    Patience patience(clock, 5.0);
    clock.pass(kSecond_ns);
    EXPECT_EQ(patience.verdict(), Patience::Verdict::kWait);
    clock.setRos(now_s);
    Patience::Verdict verdict = Patience::Verdict::kWait;
    const double waited = waited_s(clock, patience, verdict);
    EXPECT_EQ(verdict, Patience::Verdict::kTooLong);
    EXPECT_GE(waited, 2.9);
    EXPECT_LE(waited, 4.1);
  }
}

TEST(Patience, BeginsAnewWithEverySignOfLife) {
  FakeClock clock;
  Patience patience(clock, 1.0);
  for (int i = 0; i < 100; ++i) {
    clock.pass(9 * kSecond_ns / 10);
    ASSERT_EQ(patience.verdict(), Patience::Verdict::kWait);
    patience.renew();
  }
  clock.pass(kSecond_ns);
  clock.pass(kSecond_ns / 10);
  patience.verdict();
  clock.pass(kSecond_ns / 10);
  EXPECT_EQ(patience.verdict(), Patience::Verdict::kTooLong);
}

}  // namespace
}  // namespace hexapod
