#include "calibration/choose_behaviors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "made_trials.h"

namespace hexapod {
namespace {

std::vector<Entry> entries() {
  std::vector<Entry> entries;
  for (const Genome& gait : walkingGaits()) {
    entries.emplace_back();
    entries.back().genome = gait;
  }
  return entries;
}

TEST(ChooseBehaviors, LeavesOutWhatTellsNothing) {
  std::vector<Entry> all = entries();
  // It stands still, whatever its body.
  all.emplace_back();
  all.back().genome = Genome(24, 0);
  const std::vector<std::size_t> chosen =
      chooseBehaviors(*imaginationOf(), Physics(), all, 4, 0.004, 0.012);
  EXPECT_EQ(std::set<std::size_t>(chosen.begin(), chosen.end()),
            (std::set<std::size_t>{0, 1, 2, 3}));
}

TEST(ChooseBehaviors, KeepsTheRobotNearToWhereItBegins) {
  const std::vector<Entry> all = entries();
  const std::vector<std::size_t> chosen =
      chooseBehaviors(*imaginationOf(), Physics(), all, 4, 0.004, 0.012);
  // The shortest comes first.
  std::vector<double> far_m;
  const auto stand = imaginationOf()->stands({Physics()}).front();
  for (const std::size_t i : chosen) {
    const auto played = imaginationOf()->playAll({all[i].genome}, {Physics(), &*stand});
    far_m.push_back(distance(played.front().end_pose, Pose2()));
  }
  EXPECT_EQ(std::min_element(far_m.begin(), far_m.end()), far_m.begin());
}

TEST(ChooseBehaviors, SaysWhenThereAreTooFew) {
  EXPECT_THROW(chooseBehaviors(*imaginationOf(), Physics(), entries(), 5, 0.004, 0.012),
               std::invalid_argument);
}

}  // namespace
}  // namespace hexapod
