#include "evolution/targets.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "analytic_evaluator.h"

namespace hexapod {
namespace {

const std::vector<Target> kTargets = {{0.2, 0.0}, {0.0, 0.2}, {5.0, 5.0}};

TEST(Targets, GivesTheTargetsTheirTurns) {
  AnalyticEvaluator evaluator;
  Targets targets({}, 24, Random(1), kTargets, 0.1);
  for (int i = 0; i < 7; ++i) advance(targets, evaluator);
  EXPECT_EQ(targets.counters().evaluations, 700);
  EXPECT_EQ(targets.nearest().size(), 3u);
}

TEST(Targets, ATargetThatNothingComesNearToHasNoOrientationEntry) {
  AnalyticEvaluator evaluator;
  Targets targets({}, 24, Random(1), kTargets, 0.1);
  for (int i = 0; i < 30; ++i) advance(targets, evaluator);
  std::vector<std::int64_t> owners;
  for (const Entry& entry : targets.bestAligned()) owners.push_back(entry.id);
  EXPECT_EQ(owners, (std::vector<std::int64_t>{1, 2}));
}

TEST(Targets, IsTheSameHoweverManyMoreTargetsThereAre) {
  AnalyticEvaluator evaluator;
  Targets alone({}, 24, Random(1), {kTargets[0]}, 0.1);
  Targets among({}, 24, Random(1), kTargets, 0.1);
  for (int i = 0; i < 4; ++i) advance(alone, evaluator);
  for (int i = 0; i < 12; ++i) advance(among, evaluator);
  EXPECT_EQ(alone.nearest()[0].genome, among.nearest()[0].genome);
}

TEST(Targets, RefusesToHaveNoTargets) {
  EXPECT_THROW(Targets({}, 24, Random(1), {}, 0.1), std::invalid_argument);
}

}  // namespace
}  // namespace hexapod
