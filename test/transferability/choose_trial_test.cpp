#include "transferability/choose_trial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "common/random.h"

namespace hexapod {
namespace {

Entry entryAt(double x_m, double y_m, double yaw_rad = 0.0) {
  Entry entry;
  entry.end_pose = {x_m, y_m, yaw_rad};
  return entry;
}

FeatureScales scalesOf(double length_m) { return {length_m, kGeneLevels, {}}; }

RobotTrial trialOf(const Entry& entry) { return {0, entry.genome, entry.end_pose, 0.0, {}}; }

TEST(FarthestFromTried, BeginsFarthestFromStandingStill) {
  const std::vector<Entry> entries{entryAt(0.1, 0.0), entryAt(0.0, -0.5), entryAt(0.3, 0.3)};
  EXPECT_EQ(farthestFromTried(entries, {}, scalesOf(0.3)), 1u);
}

TEST(FarthestFromTried, CountsHeadingsByTheLength) {
  // The second is 0.3 m/rad * 2 rad = 0.6 m of turning away, the first 0.5 m.
  const std::vector<Entry> entries{entryAt(0.5, 0.0), entryAt(0.0, 0.0, 2.0)};
  EXPECT_EQ(farthestFromTried(entries, {}, scalesOf(0.3)), 1u);
  EXPECT_EQ(farthestFromTried(entries, {}, scalesOf(0.2)), 0u);
}

TEST(FarthestFromTried, TakesImagesOfWhatWasTriedForTried) {
  const std::vector<Entry> entries{entryAt(0.5, 0.2), entryAt(0.5, -0.2), entryAt(0.2, 0.0)};
  std::vector<RobotTrial> trials{trialOf(entries[0])};
  EXPECT_EQ(farthestFromTried(entries, trials, scalesOf(0.3)), 1u);
  const FeatureScales mirrored{0.3, kGeneLevels, {Symmetry(1.0, -1.0, {})}};
  EXPECT_EQ(farthestFromTried(entries, trials, mirrored), 2u);
}

TEST(FarthestFromTried, SpreadsTrialsOverAllThereIs) {
  Random random(3);
  std::vector<Entry> entries;
  for (int i = 0; i < 500; ++i) {
    entries.push_back(entryAt(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)));
  }
  std::vector<RobotTrial> trials;
  std::set<std::size_t> chosen;
  for (int i = 0; i < 25; ++i) {
    chosen.insert(farthestFromTried(entries, trials, scalesOf(0.3)));
    trials.push_back(trialOf(entries[farthestFromTried(entries, trials, scalesOf(0.3))]));
  }
  EXPECT_EQ(chosen.size(), 25u);
  // On a grid of 25 of so large a square none is farther than half a diagonal of 0.2 m from one:
  // farthest first is at most twice as bad as the best (Gonzalez 1985).
  for (const Entry& entry : entries) {
    const bool is_near = std::any_of(trials.begin(), trials.end(), [&](const RobotTrial& trial) {
      return distance(trial.simulated, entry.end_pose) <= 0.2 * 1.4143;
    });
    EXPECT_TRUE(is_near) << entry.end_pose.x_m << " " << entry.end_pose.y_m;
  }
}

}  // namespace
}  // namespace hexapod
