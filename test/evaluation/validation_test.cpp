#include "evaluation/validation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <stdexcept>

#include "evolution/evaluator.h"
#include "simulation/test_robots.h"

namespace hexapod {
namespace {

ValidationOptions fewTrials() {
  ValidationOptions options;
  options.trials = 3;
  options.start_states = 4;
  options.seed = 11;
  return options;
}

void expectEqual(const Execution& found, const Execution& expected) {
  EXPECT_EQ(found.mean.x_m, expected.mean.x_m);
  EXPECT_EQ(found.mean.y_m, expected.mean.y_m);
  EXPECT_EQ(found.mean.yaw_rad, expected.mean.yaw_rad);
  EXPECT_EQ(found.spread_m, expected.spread_m);
  EXPECT_EQ(found.spread_rad, expected.spread_rad);
  EXPECT_EQ(found.trials, expected.trials);
  EXPECT_EQ(found.falls, expected.falls);
}

Outcome walked(double x_m, double y_m, double yaw_rad) {
  Outcome outcome;
  outcome.verdict = Verdict::kWalked;
  outcome.end_pose = {x_m, y_m, yaw_rad};
  return outcome;
}

TEST(Summarize, GivesMeanSpreadAndFalls) {
  Outcome fell;
  fell.verdict = Verdict::kFell;
  fell.end_pose = {100.0, 100.0, 1.0};
  // Headings 0.1 on either side of the half turn.
  const double pi = std::acos(-1.0);
  const Execution execution =
      summarize({walked(0.2, 0.1, pi - 0.1), fell, walked(0.4, 0.1, -pi + 0.1)});
  EXPECT_EQ(execution.trials, 3);
  EXPECT_EQ(execution.falls, 1);
  EXPECT_NEAR(execution.mean.x_m, 0.3, 1e-12);
  EXPECT_NEAR(execution.mean.y_m, 0.1, 1e-12);
  EXPECT_NEAR(std::abs(execution.mean.yaw_rad), pi, 1e-12);
  EXPECT_NEAR(execution.spread_m, 0.1, 1e-12);  // sqrt((0.1^2 + 0.1^2) / 2)
  EXPECT_NEAR(execution.spread_rad, 0.1, 1e-12);
}

TEST(Summarize, IsZeroWithoutAnyThatWalked) {
  const Execution execution = summarize({Outcome(), Outcome()});
  EXPECT_EQ(execution.trials, 2);
  EXPECT_EQ(execution.falls, 2);
  EXPECT_EQ(execution.mean.x_m, 0.0);
  EXPECT_EQ(execution.spread_m, 0.0);
}

TEST(Validate, GivesTheSameOnAnyNumberOfThreadsAndReportsProgress) {
  const RobotDescription robot = handMadeHexapod();
  std::vector<Genome> genomes = randomGenomes(robot, 4, 3);
  genomes.push_back(tripod(robot));
  const auto one = std::make_shared<WorldPool>(Engine::kOde, robot, Physics(), 1);
  const std::vector<Execution> expected = validate(one, shortBehavior(), genomes, fewTrials());
  ASSERT_EQ(expected.size(), genomes.size());
  for (const Execution& execution : expected) {
    EXPECT_EQ(execution.trials, 3);
    EXPECT_EQ(execution.falls, 0);
    EXPECT_LT(execution.spread_m, 0.1);
  }
  EXPECT_GT(expected.back().mean.x_m, 0.05);
  EXPECT_GT(expected.back().spread_m, 1e-5);

  const auto three = std::make_shared<WorldPool>(Engine::kOde, robot, Physics(), 3);
  std::vector<std::size_t> progress;
  PlayHooks hooks;
  hooks.progress = [&](std::size_t done, std::size_t total) {
    EXPECT_EQ(total, 5u * 3u);
    progress.push_back(done);
  };
  const std::vector<Execution> found =
      validate(three, shortBehavior(), genomes, fewTrials(), hooks);
  for (std::size_t i = 0; i < found.size(); ++i) expectEqual(found[i], expected[i]);
  std::vector<std::size_t> one_by_one(15);
  std::iota(one_by_one.begin(), one_by_one.end(), std::size_t{1});
  EXPECT_EQ(progress, one_by_one);
}

TEST(Validate, CountsFallsOfAGenomeAndDrawsOtherPredecessors) {
  const RobotDescription robot = hexapodWithWideHips();
  const auto worlds = std::make_shared<WorldPool>(Engine::kOde, robot, Physics(), 1);
  const std::vector<Execution> executions =
      validate(worlds, shortBehavior(), {tripod(robot), standing(robot)}, fewTrials());
  EXPECT_EQ(executions[0].falls, 3);
  EXPECT_EQ(executions[1].falls, 0);
  EXPECT_LT(executions[1].spread_m, 1e-3);
}

TEST(Validate, StopsWhenCancelled) {
  const RobotDescription robot = handMadeHexapod();
  const auto worlds = std::make_shared<WorldPool>(Engine::kOde, robot, Physics(), 1);
  std::atomic<bool> cancelled{false};
  PlayHooks hooks;
  hooks.cancelled = &cancelled;
  hooks.progress = [&](std::size_t done, std::size_t) {
    EXPECT_EQ(done, 1u);
    cancelled = true;
  };
  EXPECT_THROW(validate(worlds, shortBehavior(), randomGenomes(robot, 3, 1), fewTrials(), hooks),
               EvaluationCancelled);
}

TEST(Validate, AcceptsAnEmptyListAndRefusesWrongOptions) {
  const auto worlds = std::make_shared<WorldPool>(Engine::kOde, handMadeHexapod(), Physics(), 1);
  EXPECT_TRUE(validate(worlds, shortBehavior(), {}, fewTrials()).empty());
  ValidationOptions wrong = fewTrials();
  wrong.trials = 5;
  EXPECT_THROW(validate(worlds, shortBehavior(), {}, wrong), std::invalid_argument);
  wrong.trials = 0;
  EXPECT_THROW(validate(worlds, shortBehavior(), {}, wrong), std::invalid_argument);
}

}  // namespace
}  // namespace hexapod
