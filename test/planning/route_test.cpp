#include "planning/route.h"

#include <gtest/gtest.h>

#include <cmath>

#include "arc_repertoire.h"
#include "made_map.h"
#include "planning/arrivals.h"
#include "planning/route_planner.h"
#include "random_goal.h"

namespace hexapod {
namespace {

const GoalTolerance kAnyHeading{0.05, -1.0};

bool isWithin(const Pose2& pose, const Waypoint& waypoint) {
  return distance(pose, waypoint.world_from_goal) <= waypoint.tolerance.xy_m + 1e-9 &&
         (waypoint.tolerance.anyHeading() ||
          headingDistance(pose, waypoint.world_from_goal) <= waypoint.tolerance.yaw_rad + 1e-9);
}

TEST(Arrivals, LieWithinTheToleranceOfTheWaypoint) {
  Random random(1);
  const GoalTolerance tolerances[] = {{0.05, -1.0}, {0.3, -1.0}, {0.3, 0.5}, {0.05, 0.5}};
  for (const GoalTolerance& tolerance : tolerances) {
    const Waypoint waypoint{randomPose(random, 3.0), tolerance};
    const std::vector<Waypoint> arrivals = arrivalsAt(waypoint, random.uniform(-3.0, 3.0));
    EXPECT_GE(arrivals.size(), 2u);
    for (const Waypoint& arrival : arrivals) {
      for (int i = 0; i < 16; ++i) {
        const double direction_rad = M_PI / 8.0 * i;
        Pose2 rim = arrival.world_from_goal;
        rim.x_m += arrival.tolerance.xy_m * std::cos(direction_rad);
        rim.y_m += arrival.tolerance.xy_m * std::sin(direction_rad);
        rim.yaw_rad += (i % 2 == 0 ? 1.0 : -1.0) * std::abs(arrival.tolerance.yaw_rad);
        EXPECT_TRUE(isWithin(rim, waypoint));
      }
    }
  }
  const Waypoint strict{{1.0, 0.0, 0.5}, {0.03, 0.05}};
  EXPECT_TRUE(arrivalsAt(strict, 0.0).empty()) << "there is nothing to choose";
}

class PlanRoute : public testing::Test {
 protected:
  RoutePlan plan(const std::vector<Waypoint>& route, const RouteMemory& memory = {},
                 const Pose2& start = {}) const {
    PlanRequest request;
    request.world_from_start = start;
    return RoutePlanner(planner_).plan(request, route, memory);
  }
  PlanResult leg(const Pose2& start, const Waypoint& waypoint) const {
    PlanRequest request;
    request.world_from_start = start;
    request.world_from_goal = waypoint.world_from_goal;
    request.tolerance = waypoint.tolerance;
    return planner_.plan(request);
  }
  /// Behaviours when each leg is planned by itself.
  std::size_t stepsOneByOne(const std::vector<Waypoint>& route) const {
    std::size_t steps = 0;
    Pose2 at;
    for (const Waypoint& waypoint : route) {
      const PlanResult plan = leg(at, waypoint);
      EXPECT_TRUE(plan.success());
      steps += plan.steps.size();
      at = plan.world_from_end;
    }
    return steps;
  }

  AdaptivePlanner planner_{arcRepertoire(300, 1), PlannerOptions(), nullptr};
};

TEST_F(PlanRoute, NeverHasMoreBehavioursThanItsLegsOneByOneAndClearlyFewerInTheMean) {
  Random random(4);
  std::size_t whole = 0;
  std::size_t one_by_one = 0;
  for (int i = 0; i < 12; ++i) {
    std::vector<Waypoint> route;
    for (int k = 0; k < 5; ++k) route.push_back({randomPose(random, 2.0), kAnyHeading});
    route.back().tolerance = {0.05, 0.17};
    const RoutePlan found = plan(route);
    ASSERT_TRUE(found.success());
    EXPECT_LE(found.steps(), stepsOneByOne(route));
    // What is proved holds of the waypoint itself, however it is arrived at.
    EXPECT_LE(found.legs.front().at_least_steps, leg({}, route.front()).steps.size());
    EXPECT_EQ(distance(found.legs.front().world_from_target, route.front().world_from_goal), 0.0);
    whole += found.steps();
    one_by_one += stepsOneByOne(route);
  }
  EXPECT_LT(static_cast<double>(whole), 0.97 * static_cast<double>(one_by_one));
}

TEST_F(PlanRoute, PassesEveryWaypointWithinItsTolerance) {
  Random random(5);
  for (int i = 0; i < 5; ++i) {
    std::vector<Waypoint> route;
    for (const GoalTolerance& tolerance :
         {GoalTolerance{0.2, -1.0}, GoalTolerance{0.05, 0.1}, GoalTolerance{0.1, 0.6}}) {
      route.push_back({randomPose(random, 2.0), tolerance});
    }
    const RoutePlan found = plan(route);
    ASSERT_EQ(found.legs.size(), 3u);
    Pose2 at;
    for (std::size_t k = 0; k < 3; ++k) {
      for (const PlannedStep& step : found.legs[k].steps) {
        at = at * planner_.repertoire().entries[step.entry].expectedPose();
      }
      EXPECT_TRUE(isWithin(at, route[k])) << k;
    }
  }
}

TEST_F(PlanRoute, EndsWithTheFirstWaypointThatHasNoPlan) {
  const RoutePlan found = plan({{{1.0, 0.0, 0.0}, kAnyHeading},
                                {{std::nan(""), 0.0, 0.0}, kAnyHeading},
                                {{2.0, 0.0, 0.0}, kAnyHeading}});
  ASSERT_EQ(found.legs.size(), 2u);
  EXPECT_EQ(found.legs[0].code, PlanCode::kFound);
  EXPECT_EQ(found.legs[1].code, PlanCode::kInvalidGoal);
  EXPECT_FALSE(found.success());
}

TEST_F(PlanRoute, FindsAWayWhereTheCheapestArrivalLeavesNone) {
  // The robot only walks ahead, or turns by a quarter to the left; a plan has two behaviours at
  // most. Whoever arrives facing away from the next waypoint needs three to get there.
  PlannerOptions options;
  options.max_steps = 2;
  const AdaptivePlanner planner(
      repertoireOf({entryTo({0.5, 0.0, 0.0}), entryTo({0.5, 0.0, M_PI_2}, 0.012, 0.02)}), options,
      nullptr);
  const std::vector<Waypoint> route = {{{1.0, 0.0, 0.0}, kAnyHeading},
                                       {{1.0, 1.0, 0.0}, kAnyHeading}};
  const RoutePlan found = RoutePlanner(planner).plan(PlanRequest{}, route);
  ASSERT_TRUE(found.success()) << found.legs.back().message;
  EXPECT_EQ(found.steps(), 4u);
}

TEST_F(PlanRoute, KeepsWhatItChoseAsLongAsTheRobotDoesWhatWasPlanned) {
  Random random(6);
  std::vector<Waypoint> route;
  for (int k = 0; k < 4; ++k) route.push_back({randomPose(random, 2.0), kAnyHeading});
  const RoutePlan first = plan(route);
  ASSERT_TRUE(first.success());
  ASSERT_GE(first.legs.front().steps.size(), 2u);
  RouteMemory memory = first.memory;
  memory.begin();
  const RoutePlan second = plan(route, memory, first.legs.front().steps.front().world_from_end);
  ASSERT_TRUE(second.success());
  EXPECT_EQ(second.steps() + 1, first.steps());
  EXPECT_EQ(second.legs.front().steps.front().id, first.legs.front().steps[1].id);
  for (std::size_t k = 0; k < route.size(); ++k) {
    EXPECT_EQ(second.memory.legs[k].arrival.world_from_goal.yaw_rad,
              first.memory.legs[k].arrival.world_from_goal.yaw_rad);
  }
}

TEST_F(PlanRoute, StaysWithinTheToleranceOfAnOccupiedWaypointThatHasAFreePartOfIt) {
  // The side of the waypoint that is nearer to the next one is occupied.
  PlanRequest request;
  request.goal_policy = GoalPolicy::kNearest;
  request.obstacles = obstaclesOf(
      [](double x_m, double y_m) { return x_m > 1.35 && x_m < 1.45 && std::abs(y_m) < 0.6; });
  const std::vector<Waypoint> route = {{{1.0, 0.0, 0.0}, {0.3, -1.0}},
                                       {{2.2, 0.0, 0.0}, kAnyHeading}};
  const RoutePlan found = RoutePlanner(planner_).plan(request, route);
  ASSERT_TRUE(found.success()) << found.legs.back().message;
  EXPECT_LE(distance(found.legs.front().world_from_end, route.front().world_from_goal), 0.3);
}

TEST_F(PlanRoute, AddsUpToOnePlan) {
  PlanResult whole;
  const PlanResult first = leg({}, {{1.0, 0.0, 0.0}, kAnyHeading});
  const PlanResult second = leg(first.world_from_end, {{1.0, 1.0, 0.0}, kAnyHeading});
  append(first, whole);
  append(second, whole);
  EXPECT_EQ(whole.code, PlanCode::kFound);
  EXPECT_EQ(whole.steps.size(), first.steps.size() + second.steps.size());
  EXPECT_NEAR(whole.length_m, first.length_m + second.length_m, 1e-12);
  EXPECT_EQ(whole.at_least_steps, first.at_least_steps);
  EXPECT_LE(distance(whole.world_from_end, {1.0, 1.0, 0.0}), 0.05);
}

}  // namespace
}  // namespace hexapod
