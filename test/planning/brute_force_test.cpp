#include <gtest/gtest.h>

#include <algorithm>

#include "arc_repertoire.h"
#include "planning/plan_cost.h"
#include "planning/planner.h"
#include "random_goal.h"

namespace hexapod {
namespace {

/// The brute-force oracle: all chains of one and two entries.
struct Shortest {
  std::size_t steps = 0;  ///< 0: none within tolerance
  double price = 1e9;     ///< the least of all
};

Shortest bruteForce(const std::vector<Move>& moves, const Pose2& goal,
                    const PlannerOptions& options) {
  Shortest result;
  const EndCost end_cost(options.tolerance(), options);
  const auto look = [&](const Pose2& end, std::size_t steps, double cost, const Uncertainty& u) {
    const double off_m = distance(end, goal);
    const double off_rad = headingDistance(end, goal);
    if (off_m > options.xy_tolerance_m || off_rad > options.yaw_tolerance_rad) return;
    if (result.steps == 0 || steps < result.steps) result.steps = steps;
    result.price = std::min(result.price, cost + end_cost(off_m, off_rad, u));
  };
  for (const Move& first : moves) {
    const Uncertainty after = Uncertainty{}.after(first, kKeptWhenReplanned);
    look(first.end, 1, first.cost, after);
    for (const Move& second : moves) {
      look(first.end * second.end, 2, first.cost + second.cost,
           after.after(second, kKeptWhenReplanned));
    }
  }
  return result;
}

TEST(Planner, IsAsShortAsBruteForceWhenEntriesAreSure) {
  Repertoire repertoire = arcRepertoire(120, 6);
  for (Entry& entry : repertoire.entries) entry = entryTo(entry.end_pose, 0.0, 0.0);
  PlannerOptions options;
  options.unvalidated_spread_m = 0.0;
  options.unvalidated_spread_rad = 0.0;
  const Planner planner(repertoire, options);
  const std::vector<Move> moves = usableMoves(repertoire, options);
  Random random(7);
  int short_ones = 0;
  for (int i = 0; i < 150; ++i) {
    const Pose2 goal = randomPose(random, 1.2);
    const Shortest shortest = bruteForce(moves, goal, options);
    const PlanResult plan = planner.plan(requestTo(goal));
    if (shortest.steps == 0 || plan.code == PlanCode::kAlreadyThere) continue;
    ++short_ones;
    EXPECT_EQ(plan.steps.size(), shortest.steps) << plan.message;
  }
  EXPECT_GT(short_ones, 50);
}

TEST(Planner, CostsNoMoreThanTheBestOfAllShortChains) {
  for (const std::int64_t max_pairs : {100000, 900}) {
    PlannerOptions options;
    options.max_pairs = max_pairs;
    const Repertoire repertoire = arcRepertoire(120, 8);
    const Planner planner(repertoire, options);
    const std::vector<Move> moves = usableMoves(repertoire, options);
    const EndCost end_cost(options.tolerance(), options);
    Random random(9);
    for (int i = 0; i < 100; ++i) {
      const Pose2 goal = randomPose(random, 1.2);
      const PlanResult plan = planner.plan(requestTo(goal));
      if (plan.code != PlanCode::kFound) continue;
      double price = 0.0;
      Uncertainty uncertainty;
      for (const PlannedStep& step : plan.steps) {
        const auto move = std::find_if(moves.begin(), moves.end(),
                                       [&](const Move& one) { return one.entry == step.entry; });
        ASSERT_NE(move, moves.end()) << "it is not among those that are planned with";
        price += move->cost;
        uncertainty = uncertainty.after(*move, kKeptWhenReplanned);
      }
      price += end_cost(plan.distance_m, plan.heading_rad, uncertainty);
      EXPECT_LE(price, bruteForce(moves, goal, options).price + 1e-9);
    }
  }
}

}  // namespace
}  // namespace hexapod
