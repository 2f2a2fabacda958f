#include "evolution/target_evolution.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analytic_evaluator.h"

namespace hexapod {
namespace {

constexpr Target kTarget{0.2, -0.1};

double distance(const Individual& individual) {
  const Pose2& end = individual.outcome.end_pose;
  return std::hypot(end.x_m - kTarget.x_m, end.y_m - kTarget.y_m);
}

double error(const Individual& individual) { return individual.outcome.cost; }

TargetEvolution after(int generations, Evaluator& evaluator) {
  TargetEvolution evolution({}, 24, Random(2), kTarget);
  for (int i = 0; i < generations; ++i) advance(evolution, evaluator);
  return evolution;
}

TEST(TargetEvolution, ComesNearerToItsTargetAndBetterAligned) {
  AnalyticEvaluator evaluator;
  const TargetEvolution young = after(1, evaluator);
  const TargetEvolution old = after(30, evaluator);
  EXPECT_LT(distance(*old.nearest()), 0.5 * distance(*young.nearest()));
  EXPECT_LT(error(*old.bestAligned(0.1)), error(*young.bestAligned(0.1)));
  EXPECT_EQ(old.counters().evaluations, 3000);
  EXPECT_EQ(old.population().size(), 100u);
}

TEST(TargetEvolution, NearestIsTheNearestOfAllAndNotDominated) {
  AnalyticEvaluator evaluator;
  const TargetEvolution evolution = after(5, evaluator);
  const Individual nearest = *evolution.nearest();
  for (const Individual& other : evolution.population()) {
    if (!other.outcome.walked()) continue;
    EXPECT_LE(distance(nearest), distance(other));
    EXPECT_FALSE(distance(other) == distance(nearest) && error(other) < error(nearest));
  }
}

TEST(TargetEvolution, BestAlignedIsTheBestWithinTheRadius) {
  AnalyticEvaluator evaluator;
  const TargetEvolution evolution = after(5, evaluator);
  const Individual best = *evolution.bestAligned(0.1);
  EXPECT_LE(distance(best), 0.1);
  EXPECT_EQ(best.standing.rank, 0u);
  for (const Individual& other : evolution.population()) {
    if (!other.outcome.walked() || distance(other) > 0.1) continue;
    EXPECT_LE(error(best), error(other));
  }
}

TEST(TargetEvolution, HasNobodyWithinNoRadius) {
  AnalyticEvaluator evaluator;
  EXPECT_FALSE(after(1, evaluator).bestAligned(1e-9).has_value());
}

/// Nothing ever walks.
class Ice : public Evaluator {
 public:
  std::vector<Outcome> evaluate(const std::vector<Genome>& genomes) override {
    return std::vector<Outcome>(genomes.size(), Outcome{Verdict::kFell, {}, 0.0});
  }
};

TEST(TargetEvolution, HasNobodyWhenAllFall) {
  Ice ice;
  const TargetEvolution evolution = after(3, ice);
  EXPECT_FALSE(evolution.nearest().has_value());
  EXPECT_FALSE(evolution.bestAligned(10.0).has_value());
}

}  // namespace
}  // namespace hexapod
