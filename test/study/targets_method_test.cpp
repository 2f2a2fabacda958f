#include "study/targets_method.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "../evolution/analytic_evaluator.h"
#include "study/methods.h"

namespace hexapod {
namespace {

const std::vector<Target> kTargets = {{0.2, 0.0}, {0.0, 0.2}, {5.0, 5.0}};

TEST(TargetsMethod, GivesTheTargetsTheirTurns) {
  AnalyticEvaluator evaluator;
  TargetsMethod method({}, 24, evaluator, Random(1), kTargets, 0.1);
  for (int i = 0; i < 7; ++i) method.step(100);
  EXPECT_EQ(method.evaluations(), 700);
  EXPECT_EQ(method.repertoires().at("nearest").size(), 3u);
}

TEST(TargetsMethod, ATargetThatNothingComesNearToHasNoOrientationEntry) {
  AnalyticEvaluator evaluator;
  TargetsMethod method({}, 24, evaluator, Random(1), kTargets, 0.1);
  for (int i = 0; i < 30; ++i) method.step(100);
  std::vector<std::int64_t> owners;
  const auto repertoires = method.repertoires();
  for (const Entry& entry : repertoires.at("orientation")) owners.push_back(entry.id);
  EXPECT_EQ(owners, (std::vector<std::int64_t>{1, 2}));
}

TEST(TargetsMethod, IsTheSameHoweverManyMoreTargetsThereAre) {
  AnalyticEvaluator evaluator;
  TargetsMethod alone({}, 24, evaluator, Random(1), {kTargets[0]}, 0.1);
  TargetsMethod among({}, 24, evaluator, Random(1), kTargets, 0.1);
  for (int i = 0; i < 4; ++i) alone.step(100);
  for (int i = 0; i < 12; ++i) among.step(100);
  EXPECT_EQ(alone.repertoires().at("nearest")[0].genome,
            among.repertoires().at("nearest")[0].genome);
}

TEST(TargetsMethod, RefusesToHaveNoTargets) {
  AnalyticEvaluator evaluator;
  EXPECT_THROW(TargetsMethod({}, 24, evaluator, Random(1), {}, 0.1), std::invalid_argument);
}

TEST(Methods, AreAllMadeByTheirNames) {
  AnalyticEvaluator evaluator;
  StudyOptions options;
  options.targets = 5;
  for (const std::string& name : methodNames()) {
    const auto method = makeMethod(name, {24, &evaluator, {}}, options, Random(1));
    method->step(100);
    EXPECT_EQ(method->evaluations(), 100) << name;
    EXPECT_FALSE(method->repertoires().empty()) << name;
  }
  EXPECT_THROW(makeMethod("annealing", {24, &evaluator, {}}, options, Random(1)),
               std::invalid_argument);
}

}  // namespace
}  // namespace hexapod
