#include "planning/move.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "arc_repertoire.h"

namespace hexapod {
namespace {

TEST(Move, SeesTheGoalFromItsEnd) {
  const PlannerOptions options;
  const Pose2 goal = {1.0, -0.4, 2.8};
  for (const Move& move : usableMoves(arcRepertoire(50, 1), options)) {
    const Pose2 expected = inverse(move.end) * goal;
    const Pose2 remaining = move.remaining(goal);
    EXPECT_NEAR(distance(remaining, expected), 0.0, 1e-12);
    EXPECT_NEAR(headingDistance(remaining, expected), 0.0, 1e-12);
  }
}

TEST(UsableMoves, TrustsASpreadByItsTrials) {
  Entry lucky = entryTo({0.5, 0.0, 0.0}, 0.0, 0.0);
  lucky.execution->trials = 1;
  Entry unvalidated = entryTo({0.5, 0.0, 0.0});
  unvalidated.execution.reset();
  PlannerOptions options;
  options.unvalidated_spread_m = 0.03;
  const auto moves = usableMoves(repertoireOf({lucky, unvalidated}), options);
  ASSERT_EQ(moves.size(), 2u);
  // sqrt((1 * 0 + 2 * 0.03^2) / (1 + 2))
  EXPECT_NEAR(moves[0].spread_m, 0.03 * std::sqrt(2.0 / 3.0), 1e-12);
  EXPECT_NEAR(moves[1].spread_m, 0.03, 1e-12);
  EXPECT_LT(moves[0].cost, moves[1].cost);
}

TEST(SpreadOut, LeavesNoMoveFarFromAChosenOne) {
  const auto moves = usableMoves(arcRepertoire(400, 2), PlannerOptions{});
  const auto chosen = spreadOut(moves, 64);
  EXPECT_EQ(std::set<std::size_t>(chosen.begin(), chosen.end()).size(), 64u);
  for (const Move& move : moves) {
    double nearest_m = 10.0;
    for (const std::size_t i : chosen) {
      nearest_m = std::min(nearest_m, distance(move.end, moves[i].end));
    }
    EXPECT_LT(nearest_m, 0.15);
  }
}

TEST(SpreadOut, TakesAllWhenThereAreFew) {
  const auto moves = usableMoves(arcRepertoire(5, 2), PlannerOptions{});
  EXPECT_EQ(spreadOut(moves, 64).size(), 5u);
  EXPECT_TRUE(spreadOut({}, 64).empty());
}

TEST(FarthestPerSector, ReachesFarthestInEachDirection) {
  const auto moves =
      usableMoves(repertoireOf({entryTo({0.5, 0.0, 0.0}), entryTo({0.3, 0.01, 0.0}),
                                entryTo({-0.2, 0.0, 0.0}), entryTo({-0.4, 0.0, 0.0})}),
                  PlannerOptions{});
  const auto farthest = farthestPerSector(moves, 4);
  EXPECT_EQ(std::set<std::size_t>(farthest.begin(), farthest.end()), (std::set<std::size_t>{0, 3}));
}

TEST(Move, OfMoreThanCanBePairedThoseThatCoverAllArePlannedWith) {
  PlannerOptions options;
  const auto all = usableMoves(arcRepertoire(400, 2), options);
  options.max_pairs = 900;
  const auto few = usableMoves(arcRepertoire(400, 2), options);
  ASSERT_EQ(few.size(), 30u);
  double farthest_m = 0.0, farthest_of_few_m = 0.0;
  for (const Move& move : all) farthest_m = std::max(farthest_m, move.length_m);
  for (std::size_t i = 0; i < few.size(); ++i) {
    if (i > 0) {
      EXPECT_LT(few[i - 1].entry, few[i].entry);
    }
    farthest_of_few_m = std::max(farthest_of_few_m, few[i].length_m);
  }
  EXPECT_EQ(farthest_of_few_m, farthest_m);
}

}  // namespace
}  // namespace hexapod
