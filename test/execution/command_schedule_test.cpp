#include "execution/command_schedule.h"

#include <gtest/gtest.h>

#include "common/random.h"
#include "ms.h"

namespace hexapod {
namespace {

using Taken = CommandSchedule::Arrival;

constexpr std::int64_t kStep_ns = 15 * kMs;
constexpr std::int64_t kPeriod_ns = 30 * kMs;
constexpr std::int64_t kLatency_ns = 60 * kMs;

TEST(CommandSchedule, GivesEveryCommandItsTwoStepsWhateverTheJitterOfArrival) {
  Random random(7);
  for (int trial = 0; trial < 50; ++trial) {
    CommandSchedule schedule(kLatency_ns);
    const std::int64_t first_stamp =
        1000 * kMs + static_cast<std::int64_t>(random.below(kPeriod_ns));
    // Command k leaves at its stamp and is under way for 0 .. 40 ms, in order.
    std::vector<std::int64_t> arrival;
    for (int k = 0; k < 40; ++k) {
      const std::int64_t at =
          first_stamp + k * kPeriod_ns + static_cast<std::int64_t>(random.below(40 * kMs));
      arrival.push_back(arrival.empty() ? at : std::max(at, arrival.back()));
    }
    std::size_t sent = 0;
    std::vector<double> acting;
    for (std::int64_t step = 900 * kMs; sent < 40 || schedule.waiting() > 0; step += kStep_ns) {
      for (; sent < 40 && arrival[sent] <= step; ++sent) {
        const std::int64_t stamp = first_stamp + static_cast<std::int64_t>(sent) * kPeriod_ns;
        EXPECT_EQ(schedule.add(stamp, step - kStep_ns, {static_cast<double>(sent)}),
                  Taken::kScheduled);
      }
      if (const auto* due = schedule.due(step)) {
        const double k = static_cast<double>((step - kLatency_ns - first_stamp) / kPeriod_ns);
        acting.push_back(due->front());
        EXPECT_EQ(due->front(), k);
      }
    }
    ASSERT_EQ(acting.size(), 40u);
  }
}

TEST(CommandSchedule, AppliesALateCommandAtOnceAndDropsAnOlderOne) {
  CommandSchedule schedule(kLatency_ns);
  EXPECT_EQ(schedule.add(1000 * kMs, 1100 * kMs, {1.0}), Taken::kLate);
  ASSERT_NE(schedule.due(1115 * kMs), nullptr);
  EXPECT_EQ(schedule.add(970 * kMs, 1115 * kMs, {0.0}), Taken::kOld);
  EXPECT_EQ(schedule.due(1130 * kMs), nullptr);
}

TEST(CommandSchedule, TheNewestOfSeveralDueCommandsActs) {
  CommandSchedule schedule(0);
  schedule.add(1000 * kMs, 900 * kMs, {1.0});
  schedule.add(1002 * kMs, 900 * kMs, {2.0});
  EXPECT_EQ(schedule.due(1005 * kMs)->front(), 2.0);
  EXPECT_EQ(schedule.waiting(), 0u);
}

TEST(CommandSchedule, AppliesUnstampedAndForeignCommandsFromTheNextStep) {
  CommandSchedule schedule(kLatency_ns);
  EXPECT_EQ(schedule.add(0, 1000 * kMs, {1.0}), Taken::kScheduled);
  EXPECT_EQ(schedule.due(1015 * kMs)->front(), 1.0);
  EXPECT_EQ(schedule.add(99'000 * kMs, 1015 * kMs, {2.0}), Taken::kForeign);
  EXPECT_EQ(schedule.due(1030 * kMs)->front(), 2.0);
  EXPECT_EQ(schedule.newestStamp_ns(), 0);
}

TEST(CommandSchedule, ForgetsCommandsButNotTheStreamWhenCleared) {
  CommandSchedule schedule(kLatency_ns);
  schedule.add(1000 * kMs, 990 * kMs, {1.0});
  schedule.clear();
  EXPECT_EQ(schedule.due(2000 * kMs), nullptr);
  EXPECT_EQ(schedule.newestStamp_ns(), 1000 * kMs);
  EXPECT_EQ(schedule.add(900 * kMs, 890 * kMs, {1.0}), Taken::kScheduled);
}

TEST(CommandSchedule, BoundsWhatWaits) {
  CommandSchedule schedule(kLatency_ns);
  int full = 0;
  for (int k = 0; k < 2000; ++k)
    full += schedule.add(1000 * kMs + k, 990 * kMs, {1.0}) == Taken::kFull;
  EXPECT_EQ(full, 1000);
}

}  // namespace
}  // namespace hexapod
