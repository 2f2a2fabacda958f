#include "evaluation/robust_evaluator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <stdexcept>

#include "evaluation/behavior_evaluator.h"
#include "evaluation/validation.h"
#include "simulation/physics.h"
#include "simulation/rollout.h"
#include "simulation/test_robots.h"

namespace hexapod {
namespace {

std::shared_ptr<WorldPool> pool(Engine engine = Engine::kReduced, int threads = 1) {
  return std::make_shared<WorldPool>(engine, handMadeHexapod(), Physics(), threads);
}

RobustnessOptions fewRuns() {
  RobustnessOptions options;
  options.perturbed_physics = 3;
  options.start_states = 2;
  return options;
}

/// All looks, one after the other.
std::vector<Outcome> looks(const std::shared_ptr<WorldPool>& worlds,
                           const std::vector<Genome>& genomes, const RobustnessOptions& options,
                           std::uint64_t seed = 1) {
  BehaviorEvaluator nominal(worlds, shortBehavior());
  RobustEvaluator robust(nominal, worlds, shortBehavior(), options, seed);
  std::vector<Outcome> outcomes = robust.evaluate(genomes);
  for (int look = 2; look <= robust.looks(); ++look) {
    outcomes = robust.lookAgain(look, genomes, outcomes);
  }
  return outcomes;
}

void expectNear(const std::vector<Outcome>& a, const std::vector<Outcome>& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].verdict, b[i].verdict);
    EXPECT_NEAR(a[i].end_pose.x_m, b[i].end_pose.x_m, tolerance);
    EXPECT_NEAR(a[i].end_pose.y_m, b[i].end_pose.y_m, tolerance);
    EXPECT_NEAR(a[i].end_pose.yaw_rad, b[i].end_pose.yaw_rad, tolerance);
    EXPECT_NEAR(a[i].cost, b[i].cost, tolerance);
  }
}

TEST(PerturbedPhysics, CoversTheRangeOfEachQuantityEvenly) {
  RobustnessOptions options;
  options.perturbed_physics = 10;
  options.friction_variation = 0.2;
  options.slope_variation_rad = 0.01;
  const auto all = perturbedPhysics(options, Physics(), kPeriod_s, 1);
  ASSERT_EQ(all.size(), 10u);
  std::set<int> friction_parts;
  std::set<int> slope_parts;
  std::set<double> steps_s;
  for (const Physics& physics : all) {
    checkPhysics(physics);
    friction_parts.insert(static_cast<int>(std::floor((physics.friction_scale - 0.8) / 0.04)));
    slope_parts.insert(static_cast<int>(std::floor((physics.slope_x_rad + 0.01) / 0.002)));
    steps_s.insert(physics.step_s);
  }
  EXPECT_EQ(friction_parts.size(), 10u);
  EXPECT_EQ(slope_parts.size(), 10u);
  EXPECT_EQ(steps_s, (std::set<double>{0.030 / 4, 0.030 / 3, 0.015}));
}

TEST(PerturbedPhysics, AreThoseOfTheirSeed) {
  const auto first = perturbedPhysics(fewRuns(), Physics(), kPeriod_s, 1);
  EXPECT_EQ(first[0].mass_scale,
            perturbedPhysics(fewRuns(), Physics(), kPeriod_s, 1)[0].mass_scale);
  EXPECT_NE(first[0].mass_scale,
            perturbedPhysics(fewRuns(), Physics(), kPeriod_s, 2)[0].mass_scale);
}

TEST(RobustEvaluator, TakesTheFirstLookForFinalWhenItIsOff) {
  const auto worlds = pool();
  BehaviorEvaluator nominal(worlds, shortBehavior());
  RobustEvaluator robust(nominal, worlds, shortBehavior(), {}, 1);
  EXPECT_EQ(robust.looks(), 1);
  const auto genomes = randomGenomes(worlds->robot(), 3, 1);
  const auto outcomes = robust.evaluate(genomes);
  expectNear(robust.lookAgain(2, genomes, outcomes), outcomes, 0.0);
  EXPECT_EQ(robust.simulations(), 0);
}

TEST(RobustEvaluator, GivesTheMeanAndAddsTheSpreadToTheMeanError) {
  const auto worlds = pool();
  RobustnessOptions options;
  options.perturbed_physics = 2;
  options.spread_weight_rad_per_m = 3.0;
  const Genome genome = tripod(worlds->robot());
  const Outcome found = looks(worlds, {genome}, options)[0];
  auto all = perturbedPhysics(options, Physics(), kPeriod_s, 1);
  all.push_back(Physics());
  Pose2 mean;
  double error_rad = 0.0;
  std::vector<Pose2> ends;
  for (const Physics& physics : all) {
    const auto world = makeWorld(Engine::kReduced, worlds->robot(), physics);
    const Outcome outcome =
        play(*world, Behavior(worlds->robot(), genome, shortBehavior()), kPeriod_s);
    ASSERT_TRUE(outcome.walked());
    ends.push_back(outcome.end_pose);
    mean.x_m += outcome.end_pose.x_m / 3.0;
    mean.y_m += outcome.end_pose.y_m / 3.0;
    error_rad += outcome.cost / 3.0;
  }
  double squares_m2 = 0.0;
  for (const Pose2& end : ends) squares_m2 += std::pow(distance(end, mean), 2) / 3.0;
  EXPECT_NEAR(found.end_pose.x_m, mean.x_m, 1e-5);
  EXPECT_NEAR(found.end_pose.y_m, mean.y_m, 1e-5);
  EXPECT_NEAR(found.cost, error_rad + 3.0 * std::sqrt(squares_m2), 2e-5);
}

TEST(RobustEvaluator, CostsTheSpreadAloneWhereTheQualityIsSteadiness) {
  const auto worlds = pool();
  RobustnessOptions options;
  options.perturbed_physics = 2;
  options.spread_weight_rad_per_m = 3.0;
  options.first_look_handicap_rad = 0.1;
  options.quality = "steadiness";
  const Genome genome = tripod(worlds->robot());
  const Outcome found = looks(worlds, {genome}, options)[0];
  auto all = perturbedPhysics(options, Physics(), kPeriod_s, 1);
  all.push_back(Physics());
  std::vector<Outcome> outcomes;
  for (const Physics& physics : all) {
    const auto world = makeWorld(Engine::kReduced, worlds->robot(), physics);
    outcomes.push_back(play(*world, Behavior(worlds->robot(), genome, shortBehavior()), kPeriod_s));
  }
  const Execution execution = summarize(outcomes);
  EXPECT_GT(execution.spread_rad, 0.0);
  EXPECT_NEAR(found.cost, execution.spread_rad + 3.0 * execution.spread_m, 1e-5);
  BehaviorEvaluator nominal(worlds, shortBehavior());
  RobustEvaluator robust(nominal, worlds, shortBehavior(), options, 1);
  EXPECT_EQ(robust.evaluate({genome})[0].cost, 0.1);
}

TEST(RobustEvaluator, RefusesSteadinessWithoutRunsToSeeItBy) {
  const auto worlds = pool();
  RobustnessOptions options;
  options.quality = "steadiness";
  BehaviorEvaluator nominal(worlds, shortBehavior());
  EXPECT_THROW(RobustEvaluator(nominal, worlds, shortBehavior(), options, 1),
               std::invalid_argument);
}

TEST(RobustEvaluator, GivesTheSameOnAnyNumberOfThreadsAndInAnyBatch) {
  const auto genomes = randomGenomes(handMadeHexapod(), 20, 2);
  const auto expected = looks(pool(), genomes, fewRuns());
  expectNear(looks(pool(Engine::kReduced, 4), genomes, fewRuns()), expected, 0.0);
  for (const std::size_t i : {0, 7, 19}) {
    expectNear(looks(pool(), {genomes[i]}, fewRuns()), {expected[i]}, 0.0);
  }
}

TEST(RobustEvaluator, AgreesWithOde) {
  const auto genomes = randomGenomes(handMadeHexapod(), 2, 3);
  expectNear(looks(pool(Engine::kOde), genomes, fewRuns()), looks(pool(), genomes, fewRuns()),
             1.1e-5);
}

TEST(RobustEvaluator, StartsOtherwiseThanFromAPerfectStand) {
  const auto worlds = pool();
  const Genome genome = tripod(worlds->robot());
  RobustnessOptions options;
  options.start_states = 3;
  options.spread_weight_rad_per_m = 0.0;
  const Outcome first = BehaviorEvaluator(worlds, shortBehavior()).evaluate({genome})[0];
  const Outcome found = looks(worlds, {genome}, options)[0];
  ASSERT_TRUE(found.walked());
  EXPECT_GT(distance(found.end_pose, first.end_pose), 1e-4);
  EXPECT_LT(distance(found.end_pose, first.end_pose), 0.05);
}

TEST(RobustEvaluator, CountsItsRunsAndLetsAnyFailureDecide) {
  const RobotDescription robot = hexapodWithWideHips();
  const auto worlds = std::make_shared<WorldPool>(Engine::kReduced, robot, Physics(), 1);
  RobustnessOptions options;
  options.perturbed_physics = 4;
  BehaviorEvaluator nominal(worlds, shortBehavior());
  RobustEvaluator robust(nominal, worlds, shortBehavior(), options, 1);
  // As if the tripod had not collided in the first look.
  const auto outcomes = robust.lookAgain(2, {standing(robot), tripod(robot)},
                                         {walkedTo({0.0, 0.0, 0.0}), walkedTo({0.2, 0.0, 0.0})});
  EXPECT_EQ(outcomes[0].verdict, Verdict::kWalked);
  EXPECT_EQ(outcomes[1].verdict, Verdict::kSelfCollided);
  EXPECT_EQ(robust.simulations(), 8);
}

TEST(RobustEvaluator, HandicapsFirstLooksButNotSecondOnes) {
  const auto worlds = pool();
  RobustnessOptions options = fewRuns();
  const auto genomes = randomGenomes(worlds->robot(), 3, 4);
  const auto fair = looks(worlds, genomes, options);
  options.first_look_handicap_rad = 0.1;
  expectNear(looks(worlds, genomes, options), fair, 1e-9);
  BehaviorEvaluator nominal(worlds, shortBehavior());
  RobustEvaluator robust(nominal, worlds, shortBehavior(), options, 1);
  EXPECT_NEAR(robust.evaluate(genomes)[0].cost, nominal.evaluate(genomes)[0].cost + 0.1, 1e-9);
}

TEST(RobustEvaluator, ScreensWithSomeOfItsRunsAndEndsAsIfItHadNot) {
  const auto worlds = pool();
  const auto genomes = randomGenomes(worlds->robot(), 6, 5);
  for (const auto& [physics, states] : std::vector<std::pair<int, int>>{{3, 2}, {1, 3}, {4, 0}}) {
    RobustnessOptions options;
    options.perturbed_physics = physics;
    options.start_states = states;
    const auto at_once = looks(worlds, genomes, options);
    options.screening_runs = 2;
    expectNear(looks(worlds, genomes, options), at_once, 1e-9);
  }
}

TEST(RobustEvaluator, SimulatesWhatItScreenedOnlyOnceUnlessItHasToStartAfresh) {
  const auto worlds = pool();
  RobustnessOptions options = fewRuns();
  options.screening_runs = 2;
  const std::vector<Genome> genomes = {tripod(worlds->robot()), standing(worlds->robot())};
  BehaviorEvaluator nominal(worlds, shortBehavior());
  RobustEvaluator robust(nominal, worlds, shortBehavior(), options, 1);
  ASSERT_EQ(robust.looks(), 3);
  const auto screened = robust.lookAgain(2, genomes, robust.evaluate(genomes));
  EXPECT_EQ(robust.simulations(), 2 * 2);
  const auto final = robust.lookAgain(3, genomes, screened);
  EXPECT_EQ(robust.simulations(), 2 * 5);
  RobustEvaluator fresh(nominal, worlds, shortBehavior(), options, 1);
  expectNear(fresh.lookAgain(3, genomes, screened), final, 0.0);
  EXPECT_EQ(fresh.simulations(), 2 * 5);
}

TEST(RobustEvaluator, GivesUpWhenCancelled) {
  const auto worlds = pool();
  std::atomic<bool> cancelled{false};
  BehaviorEvaluator nominal(worlds, shortBehavior());
  RobustEvaluator robust(nominal, worlds, shortBehavior(), fewRuns(), 1, &cancelled);
  const auto genomes = randomGenomes(worlds->robot(), 2, 3);
  const auto first = robust.evaluate(genomes);
  cancelled = true;
  EXPECT_THROW(robust.lookAgain(2, genomes, first), EvaluationCancelled);
}

TEST(RobustEvaluator, RefusesOptionsThatDoNotFit) {
  const auto worlds = pool();
  BehaviorEvaluator nominal(worlds, shortBehavior());
  RobustnessOptions options;
  options.perturbed_physics = 2;
  options.mass_variation = -3.0;
  EXPECT_THROW(RobustEvaluator(nominal, worlds, shortBehavior(), options, 1),
               std::invalid_argument);
}

}  // namespace
}  // namespace hexapod
