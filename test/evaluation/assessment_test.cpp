#include "evaluation/assessment.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/random.h"
#include "evaluation/behavior_evaluator.h"
#include "robot/load_robot.h"

namespace hexapod {
namespace {

class Assessment : public testing::Test {
 protected:
  void SetUp() override {
    Random random(1);
    std::vector<Genome> genomes(12, Genome(robot_.geneCount()));
    for (Genome& genome : genomes) {
      for (auto& level : genome) level = static_cast<std::uint8_t>(random.below(kGeneLevels));
      genome = canonical(genome);
    }
    const auto outcomes = BehaviorEvaluator(pool_, behavior_).evaluate(genomes);
    for (std::size_t i = 0; i < genomes.size(); ++i) {
      if (!outcomes[i].walked()) continue;
      Entry entry;
      entry.id = static_cast<std::int64_t>(i);
      entry.genome = genomes[i];
      entry.end_pose = outcomes[i].end_pose;
      entry.cost = outcomes[i].cost;
      entries_.push_back(entry);
    }
    ASSERT_GT(entries_.size(), 5u);
  }

  const RobotDescription robot_ = loadRobot("urdf/hexapod.urdf", "config/hexapod.yaml");
  const std::shared_ptr<WorldPool> pool_ =
      std::make_shared<WorldPool>(Engine::kReduced, robot_, Physics(), 1);
  const BehaviorOptions behavior_{};
  std::vector<Entry> entries_;
};

TEST_F(Assessment, FindsARepertoireAsItWasLearnedInTheWorldItWasLearnedIn) {
  const auto trials = heldOutTrials(robot_, Physics());
  ASSERT_EQ(trials.front().name, "nominal");
  const auto results = resimulate(pool_, behavior_, entries_, {trials.front()});
  EXPECT_EQ(results[0].failed, 0);
  EXPECT_EQ(results[0].p90_shift_m, 0.0);
  const auto learned = measure(learnedEndings(entries_));
  EXPECT_EQ(results[0].metrics.endings, entries_.size());
  EXPECT_EQ(results[0].metrics.sparseness_m, learned.sparseness_m);
  EXPECT_NEAR(results[0].metrics.median_error_of_all_rad, learned.median_error_of_all_rad, 2e-5);
}

TEST_F(Assessment, SeesTheShiftInEveryOtherWorld) {
  auto trials = heldOutTrials(robot_, Physics());
  trials.erase(trials.begin());
  for (const TrialResult& trial : resimulate(pool_, behavior_, entries_, trials)) {
    EXPECT_GT(trial.median_shift_m, 1e-4) << trial.name;
    EXPECT_GE(trial.p90_shift_m, trial.median_shift_m) << trial.name;
    EXPECT_EQ(trial.metrics.endings + static_cast<std::size_t>(trial.failed), entries_.size());
  }
}

TEST_F(Assessment, HoldsOutWhatLearningNeverDraws) {
  const auto trials = heldOutTrials(robot_, Physics());
  const auto has = [&](double Physics::*value, double wanted) {
    return std::any_of(trials.begin(), trials.end(), [&](const Trial& trial) {
      return std::abs(trial.physics.*value - wanted) < 1e-12;
    });
  };
  EXPECT_TRUE(has(&Physics::step_s, 0.005));
  EXPECT_TRUE(has(&Physics::friction_scale, 0.7 / 0.9));
  EXPECT_TRUE(has(&Physics::friction_scale, 1.1 / 0.9));
  EXPECT_TRUE(has(&Physics::mass_scale, 0.9));
  EXPECT_TRUE(has(&Physics::mass_scale, 1.1));
  EXPECT_TRUE(has(&Physics::servo_gain_scale, 0.8));
  EXPECT_TRUE(has(&Physics::servo_gain_scale, 1.2));
  EXPECT_TRUE(has(&Physics::torque_scale, 0.8));
}

}  // namespace
}  // namespace hexapod
