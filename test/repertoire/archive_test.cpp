#include "repertoire/archive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fixtures.h"
#include "gait/random_genome.h"
#include "geometry/arc.h"

namespace hexapod {
namespace {

constexpr double kThreshold = 0.1;
constexpr double kNovel = 0.2;
constexpr double kKnown = 0.05;

Entry entryAt(std::int64_t id, double x_m, double y_m, double error_rad) {
  Random random(static_cast<std::uint64_t>(id));
  Entry entry;
  entry.id = id;
  entry.genome = randomGenome(random);
  entry.end_pose = {x_m, y_m, 0.0};
  entry.cost = error_rad;
  return entry;
}

TEST(Archive, AddsANovelCandidateHoweverBadlyAligned) {
  Archive archive({entryAt(1, 0.0, 0.0, 0.1)});
  const OfferResult result = archive.offer(entryAt(2, 0.3, 0.0, 3.0), kNovel, kThreshold);
  EXPECT_EQ(result.status, AddStatus::kAdded);
  EXPECT_FALSE(result.displaced);
  EXPECT_EQ(archive.size(), 2U);
}

TEST(Archive, ANoveltyOfExactlyTheThresholdIsNotNovel) {
  Archive archive;
  EXPECT_EQ(archive.offer(entryAt(1, 0.0, 0.0, 0.1), kThreshold, kThreshold).status,
            AddStatus::kRejected);
}

TEST(Archive, SwapsABetterCandidateWithItsNearestOnly) {
  Archive archive({entryAt(1, 0.0, 0.0, 1.0), entryAt(2, 0.5, 0.0, 1.0)});
  const Entry candidate = entryAt(3, 0.4, 0.0, 0.5);
  const OfferResult result = archive.offer(candidate, kKnown, kThreshold);
  ASSERT_EQ(result.status, AddStatus::kSwapped);
  EXPECT_EQ(result.displaced->id, 2);
  ASSERT_EQ(archive.size(), 2U);
  EXPECT_EQ(archive.entries()[0].id, 1);
  EXPECT_EQ(archive.entries()[1].id, 3);
  EXPECT_FALSE(archive.contains(result.displaced->genome));
  EXPECT_TRUE(archive.contains(candidate.genome));
}

TEST(Archive, KeepsItsNearestWhenTheCandidateIsWorseOrEqual) {
  Archive archive({entryAt(1, 0.0, 0.0, 1.0)});
  EXPECT_EQ(archive.offer(entryAt(2, 0.0, 0.0, 1.5), kKnown, kThreshold).status,
            AddStatus::kRejected);
  EXPECT_EQ(archive.offer(entryAt(3, 0.0, 0.0, 1.0), kKnown, kThreshold).status,
            AddStatus::kRejected);
  EXPECT_EQ(archive.entries().front().id, 1);
}

TEST(Archive, SwapsWithTheLowerIdOfTwoEquallyNear) {
  Archive archive({entryAt(8, 0.1, 0.0, 1.0), entryAt(5, -0.1, 0.0, 1.0)});
  EXPECT_EQ(archive.offer(entryAt(9, 0.0, 0.0, 0.5), kKnown, kThreshold).displaced->id, 5);
}

TEST(Archive, TakesAGenomeOnlyOnce) {
  Archive archive({entryAt(1, 0.0, 0.0, 1.0)});
  Entry again = entryAt(1, 0.9, 0.0, 0.1);
  again.id = 2;
  EXPECT_EQ(archive.offer(again, kNovel, kThreshold).status, AddStatus::kRejected);
}

TEST(Archive, AnEmptyOneHasNothingToSwapWith) {
  Archive archive;
  EXPECT_EQ(archive.offer(entryAt(1, 0.0, 0.0, 0.0), kKnown, kThreshold).status,
            AddStatus::kRejected);
  EXPECT_EQ(archive.size(), 0U);
}

TEST(Archive, NeverShrinksAndNeverWorsensWhateverIsOffered) {
  Random random(4);
  const auto candidates = randomEntries(3000, random);
  Archive archive;
  for (const Entry& candidate : candidates) {
    const std::vector<Entry> before = archive.entries();
    const OfferResult result = archive.offer(candidate, random.uniform(0.0, 0.11), kThreshold);
    const std::vector<Entry>& after = archive.entries();
    ASSERT_EQ(after.size(), before.size() + (result.status == AddStatus::kAdded ? 1 : 0));
    std::size_t changed = 0;
    for (std::size_t slot = 0; slot < before.size(); ++slot) {
      ASSERT_LE(after[slot].cost, before[slot].cost);
      if (after[slot].id == before[slot].id) continue;
      ++changed;
      // Brute force: nothing was nearer to the candidate than what had to leave.
      for (const Entry& entry : before) {
        ASSERT_LE(distance(before[slot].end_pose, candidate.end_pose),
                  distance(entry.end_pose, candidate.end_pose));
      }
    }
    ASSERT_EQ(changed, result.status == AddStatus::kSwapped ? 1U : 0U);
  }
  std::set<std::int64_t> ids;
  std::set<Genome> genomes;
  for (const Entry& entry : archive.entries()) {
    EXPECT_TRUE(ids.insert(entry.id).second);
    EXPECT_TRUE(genomes.insert(entry.genome).second);
  }
  EXPECT_GT(archive.size(), 100U);
}

TEST(Archive, ComparesByWhatIsKnownOfARobotToo) {
  Archive archive({entryAt(1, 0.0, 0.0, 0.1)});
  Entry better = entryAt(2, 0.01, 0.0, 0.05);
  better.disparity = 0.06;  // 0.05 + 0.06 > 0.1
  EXPECT_EQ(archive.offer(better, kKnown, kThreshold).status, AddStatus::kRejected);
  archive.setDisparities([](const Entry& entry) { return 0.2 * static_cast<double>(entry.id); });
  EXPECT_EQ(archive.entries()[0].disparity, 0.2);
  EXPECT_EQ(archive.offer(better, kKnown, kThreshold).status, AddStatus::kSwapped);
}

TEST(Archive, RefusesEntriesItCannotKeepApartOrPlace) {
  const Entry first = entryAt(1, 0.0, 0.0, 0.1);
  Entry same_id = entryAt(2, 0.1, 0.0, 0.1);
  same_id.id = 1;
  Entry same_genome = first;
  same_genome.id = 2;
  Entry nowhere = entryAt(3, std::nan(""), 0.0, 0.1);
  Entry misaligned = entryAt(4, 0.0, 0.0, std::numeric_limits<double>::infinity());
  EXPECT_THROW(Archive({first, same_id}), std::invalid_argument);
  EXPECT_THROW(Archive({first, same_genome}), std::invalid_argument);
  EXPECT_THROW(Archive({nowhere}), std::invalid_argument);
  EXPECT_THROW(Archive().offer(misaligned, kNovel, kThreshold), std::invalid_argument);
}

}  // namespace
}  // namespace hexapod
