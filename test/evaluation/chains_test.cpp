#include "evaluation/chains.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>

#include "evaluation/test_set.h"
#include "simulation/physics.h"
#include "simulation/rollout.h"
#include "simulation/test_robots.h"

namespace hexapod {
namespace {

std::vector<Entry> entriesOf(const std::vector<Genome>& genomes) {
  std::vector<Entry> entries;
  for (const Genome& genome : genomes) {
    Entry entry;
    entry.genome = genome;
    entry.end_pose = {0.1, 0.02, 0.1};
    entries.push_back(entry);
  }
  return entries;
}

std::vector<ChainResult> chained(const RobotDescription& robot, const std::vector<Genome>& genomes,
                                 const std::vector<Physics>& physics, const ChainOptions& options,
                                 int threads = 1) {
  const auto pool = std::make_shared<WorldPool>(Engine::kReduced, robot, Physics(), threads);
  return chainAtRandom(pool, shortBehavior(), entriesOf(genomes), physics, options);
}

TEST(ChainAtRandom, GoesOnWhereTheBehaviourBeforeEnded) {
  const RobotDescription robot = handMadeHexapod();
  const Genome genome = tripod(robot);
  ChainOptions options;
  options.chains = 1;
  options.behaviors = 3;
  const ChainResult found = chained(robot, {genome}, {Physics()}, options).front();
  const auto world = makeWorld(Engine::kReduced, robot, Physics());
  const Behavior behavior(robot, genome, shortBehavior());
  ASSERT_EQ(found.misses_m.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    const Outcome outcome = play(*world, behavior, kPeriod_s);
    EXPECT_EQ(found.misses_m[k], distance(outcome.end_pose, {0.1, 0.02, 0.1}));
    EXPECT_EQ(found.misses_rad[k], headingDistance(outcome.end_pose, {0.1, 0.02, 0.1}));
  }
}

TEST(ChainAtRandom, CountsFailuresAndGoesOnFromTheStand) {
  const RobotDescription robot = hexapodWithWideHips();  // the tripod's legs touch
  ChainOptions options;
  options.chains = 2;
  options.behaviors = 10;
  const ChainResult found =
      chained(robot, {tripod(robot), standing(robot)}, {Physics()}, options).front();
  EXPECT_EQ(found.behaviors(), 20);
  EXPECT_GT(found.failed, 0);
  EXPECT_LT(found.failed, 20);
}

TEST(ChainAtRandom, IsTheSameForTheSameSeedOnAnyNumberOfThreads) {
  const RobotDescription robot = handMadeHexapod();
  const std::vector<Genome> genomes = randomGenomes(robot, 5, 4);
  std::vector<Physics> physics(2);
  physics[1].friction_scale = 0.7;
  ChainOptions options;
  options.chains = 5;
  options.behaviors = 2;
  const auto one = chained(robot, genomes, physics, options);
  const auto four = chained(robot, genomes, physics, options, 4);
  for (const std::size_t p : {0, 1}) {
    EXPECT_EQ(one[p].misses_m, four[p].misses_m);
    EXPECT_EQ(one[p].misses_rad, four[p].misses_rad);
    EXPECT_EQ(one[p].failed, four[p].failed);
  }
  EXPECT_NE(one[0].misses_m, one[1].misses_m);
  options.seed = 2;
  EXPECT_NE(chained(robot, genomes, physics, options)[0].misses_m, one[0].misses_m);
}

TEST(ChainResults, AddUp) {
  ChainResult a{1, {0.1, 0.2}, {0.3, 0.4}};
  a.add({2, {0.5}, {0.6}});
  EXPECT_EQ(a.failed, 3);
  EXPECT_EQ(a.behaviors(), 6);
  EXPECT_EQ(quantile(a.misses_m, 0.5), 0.2);
  EXPECT_EQ(quantile(a.misses_rad, 1.0), 0.6);
}

TEST(TestSet, CoversMoreThanLearningDrawsOfEveryQuantity) {
  const std::vector<Physics> worlds = testSet(Physics(), kPeriod_s);
  ASSERT_EQ(worlds.size(), 20u);
  const auto range = [&](double Physics::*value) {
    const auto [low, high] = std::minmax_element(
        worlds.begin(), worlds.end(),
        [&](const Physics& a, const Physics& b) { return a.*value < b.*value; });
    return std::pair((*low).*value, (*high).*value);
  };
  const auto expectBeyond = [&](double Physics::*value, double low, double high) {
    EXPECT_LT(range(value).first, low);
    EXPECT_GT(range(value).second, high);
  };
  expectBeyond(&Physics::friction_scale, 0.75, 1.25);
  expectBeyond(&Physics::servo_gain_scale, 0.75, 1.25);
  expectBeyond(&Physics::mass_scale, 0.90, 1.10);
  expectBeyond(&Physics::torque_scale, 0.90, 1.10);
  expectBeyond(&Physics::slope_x_rad, -0.007, 0.007);
  expectBeyond(&Physics::slope_y_rad, -0.007, 0.007);
  expectBeyond(&Physics::command_latency_s, 0.003, 0.027);
  std::set<std::size_t> steps;
  for (const Physics& world : worlds) {
    checkPhysics(world);
    steps.insert(stepsPerCommand(kPeriod_s, world.step_s));
  }
  EXPECT_EQ(steps, (std::set<std::size_t>{6, 7, 8, 9, 10}));
}

}  // namespace
}  // namespace hexapod
