#include "planning/planner.h"

#include <gtest/gtest.h>

#include <limits>
#include <thread>

#include "arc_repertoire.h"
#include "made_map.h"
#include "random_goal.h"

namespace hexapod {
namespace {

/// Walks the plan by composing the entries' expected poses.
Pose2 composed(const Repertoire& repertoire, const PlanRequest& request, const PlanResult& plan) {
  Pose2 pose = request.world_from_start;
  for (const PlannedStep& step : plan.steps) {
    EXPECT_EQ(repertoire.entries[step.entry].id, step.id);
    pose = pose * repertoire.entries[step.entry].expectedPose();
    EXPECT_NEAR(distance(pose, step.world_from_end), 0.0, 1e-9);
    EXPECT_NEAR(headingDistance(pose, step.world_from_end), 0.0, 1e-9);
  }
  return pose;
}

bool within(const Pose2& end, const PlanRequest& request) {
  return distance(end, request.world_from_goal) <= request.tolerance.xy_m &&
         (request.tolerance.anyHeading() ||
          headingDistance(end, request.world_from_goal) <= request.tolerance.yaw_rad);
}

std::vector<std::size_t> entriesOf(const PlanResult& plan) {
  std::vector<std::size_t> entries;
  for (const PlannedStep& step : plan.steps) entries.push_back(step.entry);
  return entries;
}

class ArcPlanner : public testing::Test {
 protected:
  const Repertoire repertoire_ = arcRepertoire(400, 1);
  const Planner planner_{repertoire_, PlannerOptions{}};
};

TEST_F(ArcPlanner, EndsWithinToleranceOfAnyGoalNearby) {
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    PlanRequest request = requestTo(randomPose(random, 1.5));
    request.world_from_start = randomPose(random, 5.0);
    request.world_from_goal = request.world_from_start * request.world_from_goal;
    const PlanResult plan = planner_.plan(request);
    ASSERT_TRUE(plan.success()) << plan.message;
    const Pose2 end = composed(repertoire_, request, plan);
    EXPECT_TRUE(within(end, request)) << plan.message;
    EXPECT_NEAR(plan.distance_m, distance(end, request.world_from_goal), 1e-9);
    EXPECT_NEAR(plan.heading_rad, headingDistance(end, request.world_from_goal), 1e-9);
  }
}

TEST_F(ArcPlanner, EndsWithinToleranceOfFarGoals) {
  Random random(3);
  for (int i = 0; i < 6; ++i) {
    PlanRequest request = requestTo(randomPose(random, 19.0));
    const PlanResult plan = planner_.plan(request);
    ASSERT_EQ(plan.code, PlanCode::kFound) << plan.message;
    EXPECT_TRUE(within(composed(repertoire_, request, plan), request));
    const double far_m = distance({}, request.world_from_goal);
    EXPECT_LE(static_cast<double>(plan.steps.size()), far_m / 0.6 + 4.0);
  }
}

TEST_F(ArcPlanner, TakesAnyHeadingWhenTheToleranceIsNegative) {
  Random random(4);
  std::size_t steps = 0;
  std::size_t steps_with_heading = 0;
  for (int i = 0; i < 100; ++i) {
    PlanRequest request = requestTo(randomPose(random, 1.5));
    steps_with_heading += planner_.plan(request).steps.size();
    request.tolerance.yaw_rad = -1.0;
    const PlanResult plan = planner_.plan(request);
    ASSERT_TRUE(plan.success()) << plan.message;
    EXPECT_TRUE(within(composed(repertoire_, request, plan), request));
    steps += plan.steps.size();
  }
  EXPECT_LT(steps, steps_with_heading);
}

TEST_F(ArcPlanner, TurnsInPlace) {
  for (const double yaw_rad : {M_PI / 4, -M_PI / 2, M_PI}) {
    PlanRequest request = requestTo({0.0, 0.0, yaw_rad});
    const PlanResult plan = planner_.plan(request);
    ASSERT_EQ(plan.code, PlanCode::kFound);
    EXPECT_TRUE(within(composed(repertoire_, request, plan), request));
    EXPECT_LE(plan.steps.size(), 3u);
  }
}

TEST_F(ArcPlanner, GivesTheSamePlanEveryTimeAndFromEveryThread) {
  Random random(5);
  std::vector<PlanRequest> requests;
  for (int i = 0; i < 40; ++i) requests.push_back(requestTo(randomPose(random, 3.0)));
  const auto planAll = [&](const Planner& planner) {
    std::vector<std::vector<std::size_t>> plans;
    for (const PlanRequest& request : requests) plans.push_back(entriesOf(planner.plan(request)));
    return plans;
  };
  const auto expected = planAll(planner_);
  EXPECT_EQ(planAll(Planner(repertoire_, PlannerOptions{})), expected);
  std::vector<std::vector<std::size_t>> first;
  std::vector<std::vector<std::size_t>> second;
  std::thread one([&] { first = planAll(planner_); });
  std::thread other([&] { second = planAll(planner_); });
  one.join();
  other.join();
  EXPECT_EQ(first, expected);
  EXPECT_EQ(second, expected);
}

TEST_F(ArcPlanner, PlansAfterAMissWithLittleEffortAndHardlyMoreBehaviours) {
  Random random(4);
  double again = 0.0;
  double afresh = 0.0;
  std::size_t behaviors_again = 0;
  std::size_t behaviors_afresh = 0;
  for (int i = 0; i < 200; ++i) {
    PlanRequest request = requestTo(randomPose(random, 1.5));
    const PlanResult before = planner_.plan(request);
    if (before.steps.size() < 2) continue;
    request.world_from_start = before.steps.front().world_from_end *
                               Pose2{random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01),
                                     random.uniform(-0.02, 0.02)};
    const PlanResult fresh = planner_.plan(request);
    request.memory = before.memory;
    request.memory.is_begun = true;
    const PlanResult plan = planner_.plan(request);
    ASSERT_TRUE(fresh.success() && plan.success()) << plan.message;
    EXPECT_TRUE(within(composed(repertoire_, request, plan), request)) << plan.message;
    EXPECT_LE(plan.at_least_steps, fresh.steps.size()) << "proved what is not true";
    again += plan.effort;
    afresh += fresh.effort;
    behaviors_again += plan.steps.size();
    behaviors_afresh += fresh.steps.size();
  }
  EXPECT_LT(again, 0.5 * afresh);
  EXPECT_LT(behaviors_again, 1.03 * behaviors_afresh);
}

TEST_F(ArcPlanner, NeedsNoBehaviourWithinTolerance) {
  const PlanResult plan = planner_.plan(requestTo({0.03, 0.02, 0.1}));
  EXPECT_EQ(plan.code, PlanCode::kAlreadyThere);
  EXPECT_TRUE(plan.success());
  EXPECT_TRUE(plan.steps.empty());
}

TEST_F(ArcPlanner, RefusesGoalsAndTolerancesThatMakeNoSense) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  const auto code = [&](const PlanRequest& request) {
    const PlanResult plan = planner_.plan(request);
    EXPECT_FALSE(plan.message.empty());
    EXPECT_TRUE(plan.steps.empty());
    return plan.code;
  };
  for (const double bad : {nan, infinite, -infinite}) {
    EXPECT_EQ(code(requestTo({bad, 0.0, 0.0})), PlanCode::kInvalidGoal);
    EXPECT_EQ(code(requestTo({0.0, bad, 0.0})), PlanCode::kInvalidGoal);
    EXPECT_EQ(code(requestTo({0.0, 0.0, bad})), PlanCode::kInvalidGoal);
    PlanRequest request = requestTo({1.0, 0.0, 0.0});
    request.world_from_start.x_m = bad;
    EXPECT_EQ(code(request), PlanCode::kInvalidGoal);
    request = requestTo({1.0, 0.0, 0.0});
    request.tolerance.xy_m = bad;
    EXPECT_EQ(code(request), PlanCode::kInvalidGoal);
    request.tolerance = {0.05, bad};
    EXPECT_EQ(code(request), PlanCode::kInvalidGoal);
  }
  PlanRequest request = requestTo({1.0, 0.0, 0.0});
  for (const double bad_xy : {0.0, -0.1}) {
    request.tolerance = {bad_xy, 0.1};
    EXPECT_EQ(code(request), PlanCode::kInvalidGoal);
  }
  request.tolerance = {0.05, 0.0};
  EXPECT_EQ(code(request), PlanCode::kInvalidGoal);
  EXPECT_EQ(code(requestTo({1000.0, 0.0, 0.0})), PlanCode::kInvalidGoal);
  EXPECT_NE(planner_.plan(requestTo({1000.0, 0.0, 0.0})).message.find("max_goal_distance_m"),
            std::string::npos);
}

TEST_F(ArcPlanner, AcceptsHugeTolerances) {
  PlanRequest request = requestTo({3.0, 1.0, 0.0});
  request.tolerance = {1.0, 3.0};
  const PlanResult plan = planner_.plan(request);
  ASSERT_EQ(plan.code, PlanCode::kFound);
  EXPECT_TRUE(within(composed(repertoire_, request, plan), request));
}

TEST_F(ArcPlanner, StopsWhenToldTo) {
  PlanRequest request = requestTo({15.0, 3.0, 1.0});
  int calls = 0;
  request.stop = [&calls] { return ++calls > 20; };
  const PlanResult plan = planner_.plan(request);
  EXPECT_EQ(plan.code, PlanCode::kTimeout);
  EXPECT_LT(calls, 40);
  EXPECT_LT(plan.distance_m, distance({}, request.world_from_goal));
}

TEST_F(ArcPlanner, NamesTheNearestPoseWhenItsTimeIsUsedUp) {
  PlannerOptions options;
  options.planning_time_s = 0.001;
  const PlanResult plan = Planner(repertoire_, options).plan(requestTo({15.0, 3.0, 1.0}));
  EXPECT_EQ(plan.code, PlanCode::kTimeout);
  EXPECT_NE(plan.message.find("planning_time_s"), std::string::npos);
  EXPECT_GT(plan.world_from_end.x_m, 0.0);
}

TEST_F(ArcPlanner, KeepsToMaxSteps) {
  PlannerOptions options;
  for (int max_steps = 1; max_steps <= 4; ++max_steps) {
    options.max_steps = max_steps;
    const PlanResult plan = Planner(repertoire_, options).plan(requestTo({1.5, 0.0, 0.0}));
    EXPECT_EQ(plan.code, max_steps < 3 ? PlanCode::kTooManySteps : PlanCode::kFound);
    EXPECT_LE(plan.steps.size(), static_cast<std::size_t>(max_steps));
    // Reach is 0.7 m per behaviour.
    if (max_steps < 3) {
      EXPECT_NEAR(plan.world_from_end.x_m, 0.67 * max_steps, 0.04 * max_steps);
    }
  }
}

TEST_F(ArcPlanner, GoesAroundWhatIsNotFree) {
  PlanRequest request = requestTo({2.0, 0.0, 0.0});
  request.obstacles = obstaclesOf(
      [](double x_m, double y_m) { return std::abs(x_m - 1.0) < 0.1 && std::abs(y_m) < 0.5; });
  const PlanResult plan = planner_.plan(request);
  ASSERT_EQ(plan.code, PlanCode::kFound) << plan.message;
  const Pose2 end = composed(repertoire_, request, plan);
  EXPECT_TRUE(within(end, request));
  double farthest_aside = 0.0;
  for (const PlannedStep& step : plan.steps) {
    farthest_aside = std::max(farthest_aside, std::abs(step.world_from_end.y_m));
  }
  EXPECT_GT(farthest_aside, 0.3);
}

TEST_F(ArcPlanner, PredictsTheSpreadOfABlindWalk) {
  const PlanResult plan = planner_.plan(requestTo({2.0, 0.0, 0.0}));
  ASSERT_EQ(plan.steps.size(), 3u);
  EXPECT_NEAR(plan.spread_rad, kSpread_rad * std::sqrt(3.0), 1e-4);
  // The headings of the first two swing all that follows, about 0.67 m each.
  const double swing_m = kSpread_rad * 0.67;
  EXPECT_NEAR(plan.spread_m,
              std::sqrt(3.0 * kSpread_m * kSpread_m + (1.0 + 4.0) * swing_m * swing_m), 1e-3);
}

TEST(Planner, PrefersTheSureEntryAmongTwoThatEndAlike) {
  const Repertoire repertoire =
      repertoireOf({entryTo({0.5, 0.0, 0.0}, 0.03, 0.05), entryTo({0.5, 0.0, 0.0}, 0.004, 0.01),
                    entryTo({0.5, 0.0, 0.0}, 0.03, 0.05)});
  const PlanResult plan = Planner(repertoire, PlannerOptions{}).plan(requestTo({0.5, 0.0, 0.0}));
  EXPECT_EQ(entriesOf(plan), std::vector<std::size_t>{1});
}

TEST(Planner, RefusesOptionsOutOfRangeByName) {
  PlannerOptions options;
  options.beam_width = 0;
  try {
    Planner(arcRepertoire(10, 1), options);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("beam_width"), std::string::npos);
  }
}

}  // namespace
}  // namespace hexapod
