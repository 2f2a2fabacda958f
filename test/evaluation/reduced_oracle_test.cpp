#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "evaluation/behavior_evaluator.h"
#include "evaluation/verify.h"
#include "evolution/br_evolution.h"
#include "gait/behavior.h"
#include "simulation/ode/ode_world.h"
#include "simulation/reduced/reduced_world.h"
#include "simulation/test_robots.h"

// Whole behaviours in the reduced engine, held against ODE.

namespace hexapod {
namespace {

End playToTheEnd(World& world, const Behavior& behavior) {
  world.restart();
  End end{Verdict::kWalked, {}};
  for (std::size_t k = 0; k < behavior.commandCount(); ++k) {
    world.setTargets(behavior.command(k));
    for (int i = 0; i < 2 && end.verdict == Verdict::kWalked; ++i) end.verdict = world.step();
  }
  end.pose = footprint(world.worldFromBase());
  return end;
}

/// Random gaits and those that a short evolution comes up with.
std::vector<Genome> mixedGenomes(const std::shared_ptr<WorldPool>& worlds) {
  std::vector<Genome> genomes = randomGenomes(worlds->robot(), 120, 11);
  BehaviorEvaluator evaluator(worlds, BehaviorOptions());
  BrEvolution evolution(EvolutionOptions(), worlds->robot().geneCount(), Random(11));
  while (evolution.archive().size() < 120) advance(evolution, evaluator);
  for (std::size_t i = 0; i < 120; ++i) {
    genomes.push_back(evolution.archive().entries()[i].genome);
  }
  return genomes;
}

TEST(ReducedOracle, EndsBehavioursWhereOdeDoes) {
  const RobotDescription robot = handMadeHexapod();
  const auto ode = std::make_shared<WorldPool>(Engine::kOde, robot, Physics());
  const auto reduced = std::make_shared<WorldPool>(Engine::kReduced, robot, Physics());
  const std::vector<Genome> genomes = mixedGenomes(reduced);
  const std::vector<End> expected = playFromTheStand(ode, BehaviorOptions(), genomes);
  const std::vector<End> ends = playFromTheStand(reduced, BehaviorOptions(), genomes);
  std::vector<double> apart_m, apart_rad;
  for (std::size_t i = 0; i < genomes.size(); ++i) {
    ASSERT_EQ(ends[i].verdict, expected[i].verdict) << toString(genomes[i]);
    if (expected[i].verdict != Verdict::kWalked) continue;
    apart_m.push_back(distance(ends[i].pose, expected[i].pose));
    apart_rad.push_back(headingDistance(ends[i].pose, expected[i].pose));
  }
  ASSERT_GT(apart_m.size(), 220u);
  std::sort(apart_m.begin(), apart_m.end());
  std::sort(apart_rad.begin(), apart_rad.end());
  EXPECT_LT(apart_m[apart_m.size() / 2], 1e-7);
  EXPECT_LT(apart_m.back(), 1e-4);
  EXPECT_LT(apart_rad.back(), 1e-3);
}

TEST(ReducedOracle, SeesTheCollisionsOfLegsThatOdeSees) {
  const RobotDescription robot = hexapodWithWideHips();
  OdeWorld ode(robot, Physics());
  ReducedWorld reduced(robot, Physics());
  int collided = 0;
  for (const Genome& genome : randomGenomes(robot, 40, 5)) {
    const Behavior behavior(robot, genome, shortBehavior());
    const End expected = playToTheEnd(ode, behavior);
    const End end = playToTheEnd(reduced, behavior);
    EXPECT_EQ(end.verdict, expected.verdict) << toString(genome);
    // The same step of the same behaviour.
    EXPECT_LT(distance(end.pose, expected.pose), 1e-5) << toString(genome);
    collided += expected.verdict == Verdict::kSelfCollided;
  }
  EXPECT_GT(collided, 10);
}

TEST(ReducedOracle, LooksOftenEnoughAtLegsThatMayTouch) {
  const RobotDescription robot = hexapodWithWideHips();
  ReducedWorld world(robot, Physics()), forgetful(robot, Physics());
  for (const Genome& genome : randomGenomes(robot, 40, 6)) {
    const Behavior behavior(robot, genome, shortBehavior());
    world.restart();
    forgetful.restart();
    for (std::size_t k = 0; k < behavior.commandCount(); ++k) {
      world.setTargets(behavior.command(k));
      // A restored world looks at every pair of legs.
      forgetful.setTargets(behavior.command(k));
      forgetful.restore(forgetful.state());
      ASSERT_EQ(world.step(), forgetful.step()) << toString(genome);
    }
    ASSERT_EQ(world.state().values, forgetful.state().values);
  }
}

}  // namespace
}  // namespace hexapod
