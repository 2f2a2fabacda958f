#include "repertoire/steadiness.h"

#include <gtest/gtest.h>

#include <limits>

namespace hexapod {
namespace {

Entry entryOf(double spread_m, double spread_rad, int falls = 0) {
  Entry entry;
  entry.execution = Execution{{}, spread_m, spread_rad, 8, falls};
  return entry;
}

std::vector<std::size_t> steady(const std::vector<Entry>& entries, std::int64_t least_entries) {
  return steadyEntries(entries, {0.01, 0.02, least_entries});
}

using Indices = std::vector<std::size_t>;

TEST(SteadyEntries, AreThoseWithinBothLimits) {
  const std::vector<Entry> entries = {entryOf(0.01, 0.02), entryOf(0.011, 0.0), entryOf(0.0, 0.021),
                                      entryOf(0.002, 0.003)};
  EXPECT_EQ(steady(entries, 0), (Indices{0, 3}));
  EXPECT_EQ(steady(entries, 2), (Indices{0, 3}));
}

TEST(SteadyEntries, AreFilledUpWithTheSteadiestOfTheOthers) {
  const std::vector<Entry> entries = {entryOf(0.05, 0.0), entryOf(0.0, 0.06), entryOf(0.0, 0.0),
                                      entryOf(0.02, 0.0)};
  EXPECT_EQ(steady(entries, 2), (Indices{2, 3}));
  EXPECT_EQ(steady(entries, 3), (Indices{1, 2, 3}));
  EXPECT_EQ(steady(entries, 100), (Indices{0, 1, 2, 3}));
}

TEST(SteadyEntries, LeaveOutWhatFellAndTakeWhatWasNotValidated) {
  std::vector<Entry> entries = {entryOf(0.0, 0.0, 1), entryOf(0.02, 0.0), Entry(),
                                entryOf(std::numeric_limits<double>::quiet_NaN(), 0.0)};
  EXPECT_EQ(steady(entries, 0), (Indices{2}));
  EXPECT_EQ(steady(entries, 2), (Indices{1, 2}));
  EXPECT_EQ(steady(entries, 9), (Indices{1, 2, 3}));
  EXPECT_EQ(steady({}, 9), Indices());
}

}  // namespace
}  // namespace hexapod
