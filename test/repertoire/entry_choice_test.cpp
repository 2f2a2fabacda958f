#include "repertoire/entry_choice.h"

#include <gtest/gtest.h>

namespace hexapod {
namespace {

Entry entryTo(std::int64_t id, const Pose2& end) {
  Entry entry;
  entry.id = id;
  entry.end_pose = end;
  return entry;
}

TEST(EntryNear, FindsTheExpectedEndThatIsNearest) {
  std::vector<Entry> entries = {entryTo(1, {0.3, 0.0, 0.0}), entryTo(2, {0.3, 0.1, 0.0}),
                                entryTo(3, {-0.3, 0.0, 0.0})};
  EXPECT_EQ(entryNear(entries, 0.31, 0.06, 0.05), 1u);
  // Where it was executed counts, not where it was learned.
  entries[2].execution = Execution{{0.31, 0.06, 0.0}, 0.0, 0.0, 5, 0};
  EXPECT_EQ(entryNear(entries, 0.31, 0.06, 0.05), 2u);
}

TEST(EntryNear, FindsNoneBeyondTheReachOfAClick) {
  EXPECT_FALSE(entryNear({entryTo(1, {0.3, 0.0, 0.0})}, 0.4, 0.0, 0.05));
  EXPECT_FALSE(entryNear({}, 0.0, 0.0, 0.05));
}

TEST(BestEntry, IsTheFarthestInFrontOfTheBetterAlignedHalf) {
  const std::vector<Entry> entries = {entryTo(1, {-0.7, 0.0, 0.0}), entryTo(2, {0.4, 0.0, 0.01}),
                                      entryTo(3, {0.6, 0.0, 0.5}), entryTo(4, {0.3, 0.0, 0.9})};
  EXPECT_EQ(bestEntry(entries), 1u);
}

TEST(BestEntry, IsNoneThatFellInItsValidation) {
  Entry fallen = entryTo(1, {0.4, 0.0, 0.0});
  fallen.execution = Execution{{0.4, 0.0, 0.0}, 0.0, 0.0, 5, 1};
  EXPECT_FALSE(bestEntry({fallen}));
  EXPECT_EQ(bestEntry({fallen, entryTo(2, {0.1, 0.0, 0.0})}), 1u);
}

TEST(EntryChoice, NeighboursAreTheNearestOthersNearestFirst) {
  std::vector<Entry> entries(4);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    entries[i].id = static_cast<std::int64_t>(i) + 1;
    entries[i].end_pose.x_m = 0.1 * static_cast<double>(i * i);  // 0, 0.1, 0.4, 0.9
  }
  std::vector<std::int64_t> ids;
  for (const Entry& entry : neighboursOf(entries, entries[2], 2)) ids.push_back(entry.id);
  EXPECT_EQ(ids, (std::vector<std::int64_t>{2, 1}));
  EXPECT_EQ(neighboursOf(entries, entries[0], 9).size(), 3u);
}

}  // namespace
}  // namespace hexapod
