#include "planning/pose_table.h"

#include <gtest/gtest.h>

#include <set>

#include "common/random.h"

namespace hexapod {
namespace {

std::vector<PoseTable::Chain> randomChains(Random& random, std::uint32_t count, double size_m) {
  std::vector<PoseTable::Chain> chains;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Pose2 end = {random.uniform(-size_m, size_m), random.uniform(-0.5, 0.1),
                       random.uniform(-M_PI, M_PI)};
    chains.push_back({end, i, 0});
  }
  return chains;
}

TEST(PoseTable, VisitsEverythingInTheBoxOnce) {
  for (const double size_m : {0.01, 1.0, 1e4}) {
    Random random(1);
    auto chains = randomChains(random, 3000, size_m);
    chains.push_back({{0.0, 0.0, M_PI}, 3000, 0});
    chains.push_back({{0.0, 0.0, -M_PI}, 3001, 0});
    const PoseTable table(chains);
    EXPECT_EQ(table.size(), chains.size());
    for (int i = 0; i < 200; ++i) {
      const Pose2 centre = {random.uniform(-1.2 * size_m, 1.2 * size_m), random.uniform(-0.7, 0.3),
                            random.uniform(-M_PI, M_PI)};
      const double radius_m = random.uniform(0.0, 0.2);
      const double half_width_rad = random.chance(0.2) ? M_PI : random.uniform(0.0, 3.0);
      std::set<std::uint32_t> seen;
      table.visitNear(centre, radius_m, half_width_rad, [&](const PoseTable::Chain& chain) {
        EXPECT_TRUE(seen.insert(chain.first).second);
      });
      for (const PoseTable::Chain& chain : chains) {
        if (distance(chain.end, centre) <= radius_m &&
            headingDistance(chain.end, centre) <= half_width_rad) {
          EXPECT_EQ(seen.count(chain.first), 1u);
        }
      }
    }
  }
}

TEST(PoseTable, WithoutChainsVisitsNothing) {
  int visits = 0;
  PoseTable({}).visitNear({}, 1.0, M_PI, [&](const PoseTable::Chain&) { ++visits; });
  EXPECT_EQ(visits, 0);
}

TEST(PoseTable, OfOneChainFindsIt) {
  int visits = 0;
  PoseTable({{{0.3, 0.1, 0.2}, 0, 0}})
      .visitNear({0.3, 0.1, 0.2}, 0.0, 0.0, [&](const PoseTable::Chain&) { ++visits; });
  EXPECT_EQ(visits, 1);
}

}  // namespace
}  // namespace hexapod
