#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "evaluation/behavior_evaluator.h"
#include "simulation/reduced/batch_rollout.h"
#include "simulation/reduced/reduced_world.h"
#include "simulation/rollout.h"
#include "simulation/test_robots.h"

namespace hexapod {
namespace {

std::vector<Behavior> behaviors(const RobotDescription& robot, std::size_t count) {
  std::vector<Behavior> made;
  for (const Genome& genome : randomGenomes(robot, count, 8)) {
    made.emplace_back(robot, genome, shortBehavior());
  }
  return made;
}

std::vector<BatchRun> runs(const std::vector<Behavior>& behaviors) {
  std::vector<BatchRun> made;
  for (const Behavior& behavior : behaviors) made.push_back({&behavior, nullptr});
  return made;
}

std::vector<BatchResult> oneByOne(const RobotDescription& robot,
                                  const std::vector<BatchRun>& runs) {
  ReducedWorld world(robot, Physics());
  std::vector<BatchResult> results;
  for (const BatchRun& run : runs) {
    world.restart();
    if (run.start != nullptr) world.restore(*run.start);
    BatchResult result;
    result.outcome = play(world, *run.behavior, kPeriod_s);
    result.end = world.state();
    results.push_back(result);
  }
  return results;
}

void expectSame(const std::vector<BatchResult>& found, const std::vector<BatchResult>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].outcome.verdict, expected[i].outcome.verdict) << i;
    EXPECT_EQ(found[i].end.values, expected[i].end.values) << i;
    EXPECT_EQ(found[i].outcome.end_pose.x_m, expected[i].outcome.end_pose.x_m) << i;
    EXPECT_EQ(found[i].outcome.end_pose.y_m, expected[i].outcome.end_pose.y_m) << i;
    EXPECT_EQ(found[i].outcome.end_pose.yaw_rad, expected[i].outcome.end_pose.yaw_rad) << i;
  }
}

// Legs collide often, so lanes come free at different times.
TEST(BatchRollout, GivesTheBitsOfASingleWorldWithEveryInstructionSet) {
  const RobotDescription robot = hexapodWithWideHips();
  const std::vector<Behavior> played = behaviors(robot, 37);
  const std::vector<BatchResult> expected = oneByOne(robot, runs(played));
  for (const reduced::InstructionSet instructions : reduced::availableInstructionSets()) {
    SCOPED_TRACE(toString(instructions));
    BatchRollout batch(robot, Physics(), instructions);
    expectSame(batch.play(runs(played), kPeriod_s), expected);
  }
}

TEST(BatchRollout, GivesTheBitsOfASingleWorldForLegsOfBoxes) {
  const RobotDescription robot = hexapodOfBoxes();
  const std::vector<Behavior> played = behaviors(robot, 19);
  const std::vector<BatchResult> expected = oneByOne(robot, runs(played));
  for (const reduced::InstructionSet instructions : reduced::availableInstructionSets()) {
    SCOPED_TRACE(toString(instructions));
    BatchRollout batch(robot, Physics(), instructions);
    expectSame(batch.play(runs(played), kPeriod_s), expected);
  }
}

TEST(BatchRollout, DoesNotDependOnTheNeighbours) {
  const RobotDescription robot = hexapodWithWideHips();
  const std::vector<Behavior> played = behaviors(robot, 20);
  std::vector<BatchRun> all = runs(played);
  BatchRollout batch(robot, Physics());
  std::vector<BatchResult> expected = batch.play(all, kPeriod_s);
  std::reverse(all.begin(), all.end());
  std::reverse(expected.begin(), expected.end());
  expectSame(batch.play(all, kPeriod_s), expected);
  expectSame(batch.play({all[3]}, kPeriod_s), {expected[3]});
}

TEST(BatchRollout, StartsFromGivenStates) {
  const RobotDescription robot = handMadeHexapod();
  const std::vector<Behavior> played = behaviors(robot, 9);
  BatchRollout batch(robot, Physics());
  const std::vector<BatchResult> first = batch.play(runs(played), kPeriod_s);
  std::vector<BatchRun> chained = runs(played);
  for (std::size_t i = 0; i < chained.size(); ++i) {
    if (i % 3 != 0) chained[i].start = &first[(i + 4) % first.size()].end;
  }
  expectSame(batch.play(chained, kPeriod_s), oneByOne(robot, chained));
}

/// Each with another step, and all that may differ between lanes.
std::vector<Physics> differentPhysics() {
  std::vector<Physics> all(4);
  all[1].step_s = 0.010;
  all[1].friction_scale = 0.8;
  all[1].slope_x_rad = 0.02;
  all[2].step_s = 0.005;
  all[2].mass_scale = 1.13;
  all[2].torque_scale = 0.9;
  all[3].servo_gain_scale = 0.7;
  all[3].command_latency_s = 0.045;
  all[3].joint_torque_scales.assign(handMadeHexapod().jointCount(), 1.0);
  all[3].joint_torque_scales[4] = 0.6;
  return all;
}

TEST(BatchRollout, PlaysSeveralPhysicsSideBySideAsEachByItself) {
  const RobotDescription robot = handMadeHexapod();
  const std::vector<Behavior> played = behaviors(robot, 23);
  std::vector<BatchPhysics> physics;
  for (const Physics& one : differentPhysics()) {
    physics.push_back({one, ReducedWorld(robot, one).state()});
  }
  std::vector<BatchRun> mixed = runs(played);
  for (std::size_t i = 0; i < mixed.size(); ++i) mixed[i].physics = i % physics.size();
  for (const reduced::InstructionSet instructions : reduced::availableInstructionSets()) {
    SCOPED_TRACE(toString(instructions));
    BatchRollout batch(robot, physics, instructions);
    const std::vector<BatchResult> found = batch.play(mixed, kPeriod_s);
    for (std::size_t i = 0; i < mixed.size(); ++i) {
      ReducedWorld world(robot, physics[mixed[i].physics].physics);
      BatchResult expected;
      expected.outcome = play(world, *mixed[i].behavior, kPeriod_s);
      expected.end = world.state();
      expectSame({found[i]}, {expected});
    }
    EXPECT_GT(batch.use().register_steps, 0);
    EXPECT_LE(batch.use().lane_steps, batch.lanes() * batch.use().register_steps);
  }
}

TEST(BatchRollout, RefusesPhysicsWithLegsInOtherStates) {
  const RobotDescription robot = handMadeHexapod();
  std::vector<BatchPhysics> physics(2, {Physics(), ReducedWorld(robot, Physics()).state()});
  physics[1].physics.legs.resize(robot.legs.size());
  physics[1].physics.legs[2].condition = LegCondition::kLimp;
  EXPECT_THROW(BatchRollout(robot, physics), std::invalid_argument);
  EXPECT_THROW(BatchRollout(robot, std::vector<BatchPhysics>{}), std::invalid_argument);
}

TEST(RunQueue, GivesEveryRunOnceAndNothingOnceCancelled) {
  const std::vector<BatchRun> runs(3);
  std::atomic<bool> cancelled{false};
  std::size_t ended = 0;
  RunQueue queue(
      runs, [&](std::size_t done) { ended = done; }, &cancelled);
  EXPECT_EQ(queue.take(), std::optional<std::size_t>(0));
  EXPECT_EQ(queue.take(), std::optional<std::size_t>(1));
  queue.finish(1, {});
  EXPECT_EQ(ended, 1u);
  cancelled = true;
  EXPECT_EQ(queue.take(), std::nullopt);
  cancelled = false;
  EXPECT_EQ(queue.take(), std::optional<std::size_t>(2));
  EXPECT_EQ(queue.take(), std::nullopt);
}

TEST(BatchRollout, CountsOnlyTheLaneThatBlowsUpAsDiverged) {
  const RobotDescription robot = handMadeHexapod();
  const std::vector<Behavior> played = behaviors(robot, 5);
  BatchRollout batch(robot, Physics());
  std::vector<BatchRun> all = runs(played);
  const std::vector<BatchResult> expected = batch.play(all, kPeriod_s);
  WorldState broken = batch.settled();
  broken.values[30] = 1e200;
  all[2].start = &broken;
  const std::vector<BatchResult> found = batch.play(all, kPeriod_s);
  EXPECT_EQ(found[2].outcome.verdict, Verdict::kDiverged);
  for (const std::size_t i : {0u, 1u, 3u, 4u}) expectSame({found[i]}, {expected[i]});
}

TEST(BatchRollout, GivesAnEvaluatorTheOutcomesOfASingleWorldOnAnyNumberOfThreads) {
  const RobotDescription robot = hexapodWithWideHips();
  const std::vector<Genome> genomes = randomGenomes(robot, 21, 8);
  const std::vector<Behavior> played = behaviors(robot, 21);
  const std::vector<BatchResult> expected = oneByOne(robot, runs(played));
  for (const int threads : {1, 2, 8}) {
    SCOPED_TRACE(threads);
    const auto worlds = std::make_shared<WorldPool>(Engine::kReduced, robot, Physics(), threads);
    BehaviorEvaluator evaluator(worlds, shortBehavior());
    const std::vector<Outcome> outcomes = evaluator.evaluate(genomes);
    ASSERT_EQ(outcomes.size(), expected.size());
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      EXPECT_EQ(outcomes[i].verdict, expected[i].outcome.verdict) << i;
      EXPECT_EQ(outcomes[i].end_pose.x_m, expected[i].outcome.end_pose.x_m) << i;
      EXPECT_EQ(outcomes[i].end_pose.yaw_rad, expected[i].outcome.end_pose.yaw_rad) << i;
    }
    EXPECT_EQ(evaluator.counts().simulations, 21);
  }
}

TEST(PlayEach, GivesTheOutcomesOfPlayWithEitherEngine) {
  const RobotDescription robot = handMadeHexapod();
  const std::vector<Behavior> played = behaviors(robot, 3);
  for (const Engine engine : {Engine::kOde, Engine::kReduced}) {
    const std::unique_ptr<World> world = makeWorld(engine, robot, Physics());
    play(*world, played[2], kPeriod_s);
    const WorldState start = world->state();
    std::vector<BatchRun> chosen = runs(played);
    chosen[1].start = &start;
    const std::vector<Outcome> outcomes = playEach(*world, chosen, kPeriod_s);
    ASSERT_EQ(outcomes.size(), 3u);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      world->restart();
      if (i == 1) world->restore(start);
      const Outcome expected = play(*world, played[i], kPeriod_s);
      EXPECT_EQ(outcomes[i].end_pose.x_m, expected.end_pose.x_m);
      EXPECT_EQ(outcomes[i].end_pose.y_m, expected.end_pose.y_m);
      EXPECT_EQ(outcomes[i].end_pose.yaw_rad, expected.end_pose.yaw_rad);
    }
  }
}

TEST(BatchRollout, LetsAnEvaluatorNameTheGenomeThatCannotBeSimulated) {
  const RobotDescription robot = handMadeHexapod();
  const auto worlds = std::make_shared<WorldPool>(Engine::kReduced, robot, Physics(), 2);
  BehaviorEvaluator evaluator(worlds, shortBehavior());
  try {
    evaluator.evaluate({standing(robot), {1, 2, 3, 0}});
    FAIL() << "simulated a genome of four genes";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("Genome 1230 cannot be simulated"), std::string::npos)
        << error.what();
  }
}

TEST(BatchRollout, TakesNoRunsAtAll) {
  BatchRollout batch(handMadeHexapod(), Physics());
  EXPECT_TRUE(batch.play({}, kPeriod_s).empty());
}

TEST(BatchRollout, RefusesAPeriodThatIsNoMultipleOfTheStepAndForeignStates) {
  const RobotDescription robot = handMadeHexapod();
  const std::vector<Behavior> played = behaviors(robot, 1);
  BatchRollout batch(robot, Physics());
  EXPECT_THROW(batch.play(runs(played), 0.020), std::invalid_argument);
  const WorldState foreign{{1.0, 2.0, 3.0}};
  EXPECT_THROW(batch.play({{&played[0], &foreign}}, kPeriod_s), std::invalid_argument);
}

}  // namespace
}  // namespace hexapod
