#include <gtest/gtest.h>

#include <set>

#include "arc_repertoire.h"
#include "made_map.h"
#include "planning/planner.h"
#include "planning/steps_bound.h"
#include "random_goal.h"

namespace hexapod {
namespace {

// Few entries, so that all chains can be tried.
class FewEntries : public testing::Test {
 protected:
  FewEntries() {
    for (Entry& entry : repertoire_.entries) entry = entryTo(entry.end_pose, 0.0, 0.0);
    options_.unvalidated_spread_m = 0.0;
    options_.unvalidated_spread_rad = 0.0;
    moves_ = usableMoves(repertoire_, options_);
  }

  /// All chains of up to `most` moves; calls visit(end, steps).
  template <typename Visit>
  void everyChain(const Pose2& from, int steps, int most, Visit&& visit) const {
    if (steps == most) return;
    for (const Move& move : moves_) {
      const Pose2 end = from * move.end;
      visit(end, steps + 1);
      everyChain(end, steps + 1, most, visit);
    }
  }

  Repertoire repertoire_ = arcRepertoire(9, 3);
  PlannerOptions options_;
  std::vector<Move> moves_;
};

TEST_F(FewEntries, BoundsNeverExceedTheLengthOfAnyChainThereIs) {
  const StepsBound bound(moves_);
  const GoalTolerance tight{1e-6, 1e-6};
  const GoalTolerance any{1e-6, -1.0};
  int sharp = 0;
  everyChain(Pose2{}, 0, 5, [&](const Pose2& end, int steps) {
    ASSERT_LE(bound(end, tight), steps);
    ASSERT_LE(bound(end, any), bound(end, tight));
    sharp += steps == 5 && bound(end, tight) == 5 ? 1 : 0;
  });
  EXPECT_GT(sharp, 0) << "a bound that proves nothing";
}

TEST_F(FewEntries, PlansHaveAsManyBehavioursAsProvedAndAsTheShortestOfAllChains) {
  const Planner planner(repertoire_, options_);
  Random random(5);
  int longer = 0;
  for (int i = 0; i < 30; ++i) {
    // A goal that some chain of four leads to; others may be shorter.
    Pose2 goal;
    for (int k = 0; k < 4; ++k) goal = goal * moves_[random.below(moves_.size())].end;
    PlanRequest request = requestTo(goal);
    request.tolerance = {0.03, 0.05};
    int shortest = 5;
    everyChain(Pose2{}, 0, 4, [&](const Pose2& end, int steps) {
      if (distance(end, goal) <= 0.03 && headingDistance(end, goal) <= 0.05) {
        shortest = std::min(shortest, steps);
      }
    });
    const PlanResult plan = planner.plan(request);
    if (plan.code == PlanCode::kAlreadyThere) continue;
    ASSERT_EQ(plan.code, PlanCode::kFound) << plan.message;
    EXPECT_EQ(plan.steps.size(), static_cast<std::size_t>(shortest));
    EXPECT_EQ(plan.at_least_steps, plan.steps.size());
    longer += shortest == 4 ? 1 : 0;
  }
  EXPECT_GT(longer, 5);
}

TEST(SearchProof, SaysThatMoreThanMaxStepsAreNeeded) {
  PlannerOptions options;
  options.max_steps = 6;
  const Planner planner(arcRepertoire(300, 1), options);
  const PlanResult plan = planner.plan(requestTo({8.0, 0.0, 0.0}));
  EXPECT_EQ(plan.code, PlanCode::kTooManySteps);
  EXPECT_GE(plan.at_least_steps, 11u);  // 8 m by at most 0.7 m
  EXPECT_GT(plan.world_from_end.x_m, 3.0);
}

// A room of 4 m with a door of 1 m to the left, and the robot in it.
std::shared_ptr<const Obstacles> room(bool door) {
  return obstaclesOf([door](double x_m, double y_m) {
    const double out_m = std::max(std::abs(x_m), std::abs(y_m));
    const bool in_door = door && x_m < 0.0 && std::abs(y_m) < 0.5;
    return out_m > 2.0 && out_m < 2.1 && !in_door;
  });
}

class AmongObstacles : public testing::Test {
 protected:
  PlanResult planTo(const Pose2& goal, std::shared_ptr<const Obstacles> obstacles,
                    GoalPolicy policy = GoalPolicy::kRefuse, const Pose2& start = {}) {
    PlanRequest request = requestTo(goal);
    request.world_from_start = start;
    request.obstacles = std::move(obstacles);
    request.goal_policy = policy;
    return planner_.plan(request);
  }

  const Repertoire repertoire_ = arcRepertoire(300, 1);
  const Planner planner_{repertoire_, PlannerOptions{}};
};

TEST_F(AmongObstacles, PlansThroughTheDoorAndKeepsItsRoom) {
  const PlanResult plan = planTo({3.0, 0.0, 0.0}, room(true));
  ASSERT_EQ(plan.code, PlanCode::kFound) << plan.message;
  EXPECT_GE(plan.clearance_m, 0.0);
  EXPECT_LT(plan.clearance_m, 0.2);
  // Out at x = -2 m, around the room of 4.2 m and back: more than 9 m by at most 0.7 m.
  EXPECT_GE(plan.at_least_steps, 10u);
  EXPECT_GE(plan.steps.size(), plan.at_least_steps);
}

TEST_F(AmongObstacles, SaysThatEveryWayIsBlockedAndWhatIsNearest) {
  const PlanResult plan = planTo({3.0, 0.0, 0.0}, room(false));
  EXPECT_EQ(plan.code, PlanCode::kBlocked);
  EXPECT_NEAR(plan.world_from_end.x_m, 2.0 - 0.33, 0.1);
  EXPECT_NE(plan.message.find("close every way"), std::string::npos) << plan.message;
}

TEST_F(AmongObstacles, DoesNotCallBlockedWhatItHadNoTimeToLookFor) {
  PlanRequest request = requestTo({3.0, 0.0, 0.0});
  request.obstacles = room(false);
  request.stop = [] { return true; };
  const PlanResult plan = planner_.plan(request);
  EXPECT_EQ(plan.code, PlanCode::kTimeout);
  EXPECT_NE(plan.message.find("planning was stopped"), std::string::npos) << plan.message;
}

TEST_F(AmongObstacles, StandsInAnyHeadingOfALooseGoal) {
  // A robot of 1 m by 0.2 m in a corridor along y: it fits in lengthwise only.
  const Footprint longish{
      {{0.4, 0.0, 0.1}, {0.2, 0.0, 0.1}, {0.0, 0.0, 0.1}, {-0.2, 0.0, 0.1}, {-0.4, 0.0, 0.1}}};
  PlanRequest request = requestTo({0.0, 1.5, 0.0});
  request.world_from_start = {0.0, 0.0, M_PI_2};
  request.obstacles = std::make_shared<const Obstacles>(
      mapOf([](double x_m, double) { return std::abs(x_m) > 0.4 && std::abs(x_m) < 0.5; }), longish,
      ObstacleOptions{});
  EXPECT_EQ(planner_.plan(request).code, PlanCode::kGoalOccupied);
  request.tolerance.yaw_rad = -1.0;
  EXPECT_EQ(planner_.plan(request).code, PlanCode::kFound);
}

TEST_F(AmongObstacles, RefusesAGoalInAnObstacleOrWalksToTheNearestFreePose) {
  const Pose2 in_wall{2.05, 0.0, 0.0};
  EXPECT_EQ(planTo(in_wall, room(true)).code, PlanCode::kGoalOccupied);
  const PlanResult plan = planTo(in_wall, room(true), GoalPolicy::kNearest);
  ASSERT_EQ(plan.code, PlanCode::kFound) << plan.message;
  EXPECT_NEAR(plan.world_from_target.x_m, 2.0 - 0.33, 0.1);
  EXPECT_LE(distance(plan.world_from_end, plan.world_from_target), 0.05);
  EXPECT_NE(plan.message.find("nearest free pose"), std::string::npos) << plan.message;
}

TEST_F(AmongObstacles, SaysThatTheRobotStandsInAnObstacle) {
  EXPECT_EQ(planTo({0.0, 0.0, 0.0}, room(true), GoalPolicy::kRefuse, {1.9, 0.0, 0.0}).code,
            PlanCode::kStartOccupied);
}

TEST_F(AmongObstacles, LeavesItsMarginWithItsFirstStep) {
  const Pose2 start{2.0 - 0.31, 0.0, M_PI};
  EXPECT_EQ(planTo({0.0, 0.0, M_PI}, room(true), GoalPolicy::kRefuse, start).code,
            PlanCode::kFound);
}

TEST_F(AmongObstacles, ALessStrictGoalNeverCostsMore) {
  // A maze of three corridors of 1.1 m, one behind the other.
  const auto maze = obstaclesOf([](double x_m, double y_m) {
    const double out_m = std::max(std::abs(x_m), std::abs(y_m));
    const bool lower = std::abs(y_m + 0.6) < 0.05 && x_m < 1.0;
    const bool upper = std::abs(y_m - 0.6) < 0.05 && x_m > -1.0;
    return (out_m > 1.8 && out_m < 1.9) || (out_m < 1.9 && (lower || upper));
  });
  const Pose2 start{-1.2, -1.2, 0.0};
  for (const double heading_rad : {0.0, 1.5, 3.0, -1.5}) {
    std::size_t before = 100;
    for (const GoalTolerance& tolerance :
         {GoalTolerance{0.03, 0.087}, GoalTolerance{0.1, 0.2}, GoalTolerance{0.25, -1.0}}) {
      PlanRequest request = requestTo({1.2, 1.2, heading_rad});
      request.world_from_start = start;
      request.tolerance = tolerance;
      request.obstacles = maze;
      const PlanResult plan = planner_.plan(request);
      ASSERT_EQ(plan.code, PlanCode::kFound) << plan.message;
      EXPECT_LE(plan.steps.size(), before) << heading_rad << " " << tolerance.xy_m;
      before = plan.steps.size();
    }
  }
}

TEST_F(AmongObstacles, KeepsItsPlanOnTheWay) {
  PlanRequest request = requestTo({3.0, 0.0, 0.0});
  request.obstacles = room(true);
  PlanResult plan = planner_.plan(request);
  Random random(3);
  std::size_t steps = plan.steps.size();
  std::size_t kept = 0;
  std::size_t replans = 0;
  while (plan.code == PlanCode::kFound) {
    const std::size_t second = plan.steps.size() > 1 ? plan.steps[1].entry : 0;
    const bool had_second = plan.steps.size() > 1;
    request.world_from_start = plan.steps.front().world_from_end *
                               Pose2{0.003 * normal(random), 0.003 * normal(random), 0.0};
    request.memory = plan.memory;
    plan = planner_.plan(request);
    ASSERT_TRUE(plan.success()) << plan.message;
    if (!had_second || plan.code != PlanCode::kFound) break;
    ++replans;
    kept += plan.steps.front().entry == second ? 1 : 0;
    EXPECT_LE(plan.steps.size(), steps);
    steps = plan.steps.size();
  }
  EXPECT_EQ(plan.code, PlanCode::kAlreadyThere);
  EXPECT_GT(replans, 8u);
  EXPECT_GE(kept + 3, replans) << "dithers between plans";
}

TEST_F(AmongObstacles, ReplansWhenSomethingNewStandsInTheWay) {
  PlanRequest request = requestTo({3.0, 0.0, 0.0});
  const PlanResult before = planner_.plan(request);
  ASSERT_EQ(before.code, PlanCode::kFound);
  request.world_from_start = before.steps.front().world_from_end;
  request.memory = before.memory;
  request.obstacles = obstaclesOf(
      [](double x_m, double y_m) { return std::abs(x_m - 1.8) < 0.05 && std::abs(y_m) < 0.5; });
  const PlanResult after = planner_.plan(request);
  ASSERT_EQ(after.code, PlanCode::kFound) << after.message;
  EXPECT_GE(after.clearance_m, 0.0);
  EXPECT_GE(after.steps.size(), before.steps.size());
}

TEST_F(AmongObstacles, TellsEachBetterPlanAsItIsFound) {
  PlanRequest request = requestTo({3.0, 0.0, 0.0});
  request.obstacles = room(true);
  std::vector<std::size_t> lengths;
  request.improved = [&](std::size_t steps) { lengths.push_back(steps); };
  const PlanResult plan = planner_.plan(request);
  ASSERT_FALSE(lengths.empty());
  EXPECT_EQ(lengths.back(), plan.steps.size());
}

TEST_F(AmongObstacles, AnsweredByTheFirstPlanWhenStoppedAfterIt) {
  PlanRequest request = requestTo({3.0, 0.0, 0.0});
  request.obstacles = room(true);
  bool found = false;
  request.improved = [&](std::size_t) { found = true; };
  request.stop = [&] { return found; };
  EXPECT_EQ(planner_.plan(request).code, PlanCode::kFound);
}

}  // namespace
}  // namespace hexapod
