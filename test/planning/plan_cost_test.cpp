#include "planning/plan_cost.h"

#include <gtest/gtest.h>

#include "arc_repertoire.h"

namespace hexapod {
namespace {

TEST(MissProbability, AgreesWithTheNormalDistribution) {
  // Centre at the limit: half; limits at 1.96 deviations: 5 %.
  EXPECT_NEAR(missProbability(0.05, 0.001, 0.05), 0.5, 1e-9);
  EXPECT_NEAR(missProbability(0.0, 0.05 / 1.959964, 0.05), 0.05, 1e-6);
  EXPECT_EQ(missProbability(0.04, 0.0, 0.05), 0.0);
  EXPECT_EQ(missProbability(0.06, 0.0, 0.05), 1.0);
}

TEST(MissProbability, AgreesWithSampling) {
  Random random(1);
  int misses = 0;
  for (int i = 0; i < 20000; ++i) {
    if (std::abs(0.02 + 0.03 * normal(random)) > 0.05) ++misses;
  }
  EXPECT_NEAR(missProbability(0.02, 0.03, 0.05), misses / 20000.0, 0.01);
}

TEST(EndCost, GrowsWithErrorAndUncertainty) {
  const EndCost cost(GoalTolerance{}, PlannerOptions{});
  const Uncertainty sure = {1e-4, 1e-4, 0.0, 0.0};
  const Uncertainty unsure = {1e-3, 1e-3, 0.0, 0.0};
  EXPECT_LT(cost(0.01, 0.01, sure), cost(0.02, 0.01, sure));
  EXPECT_LT(cost(0.01, 0.01, sure), cost(0.01, 0.03, sure));
  EXPECT_LT(cost(0.01, 0.01, sure), cost(0.01, 0.01, unsure));
  EXPECT_LE(cost.margin(0.03, 0.1), cost(0.03, 0.1, sure));
}

TEST(EndCost, KnowsNoHeadingWhenAnyWillDo) {
  const EndCost cost({0.05, -1.0}, PlannerOptions{});
  EXPECT_EQ(cost(0.01, 3.0, {1e-4, 1.0, 0.0, 0.0}), cost(0.01, 0.0, {1e-4, 0.0, 0.0, 0.0}));
}

TEST(Uncertainty, AgreesWithSampling) {
  Random random(2);
  const Pose2 end = {0.5, 0.2, 0.7};
  const auto moves = usableMoves(repertoireOf({entryTo(end, 0.01, 0.05)}), PlannerOptions{});
  Uncertainty predicted;
  for (int i = 0; i < 3; ++i) predicted = predicted.after(moves[0], 1.0);
  double position_m2 = 0.0;
  double heading_rad2 = 0.0;
  constexpr int kWalks = 4000;
  const Pose2 aim = end * end * end;
  for (int i = 0; i < kWalks; ++i) {
    Pose2 pose;
    for (int step = 0; step < 3; ++step) {
      pose = pose * Pose2{end.x_m + 0.01 / std::sqrt(2.0) * normal(random),
                          end.y_m + 0.01 / std::sqrt(2.0) * normal(random),
                          end.yaw_rad + 0.05 * normal(random)};
    }
    position_m2 += std::pow(distance(pose, aim), 2) / kWalks;
    heading_rad2 += std::pow(headingDistance(pose, aim), 2) / kWalks;
  }
  EXPECT_NEAR(std::sqrt(predicted.heading_rad2), std::sqrt(heading_rad2), 0.003);
  EXPECT_NEAR(std::sqrt(predicted.position_m2), std::sqrt(position_m2), 0.003);
}

}  // namespace
}  // namespace hexapod
