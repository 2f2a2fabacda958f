#include "planning/route.h"

#include <gtest/gtest.h>

#include <cmath>

#include "arc_repertoire.h"
#include "planning/planner.h"
#include "random_goal.h"

namespace hexapod {
namespace {

const GoalTolerance kAnyHeading{0.05, -1.0};

class PlanLeg : public testing::Test {
 protected:
  PlanResult leg(const Pose2& start, const Waypoint& waypoint, const Waypoint* next) const {
    PlanRequest request;
    request.world_from_start = start;
    return planLeg([this](const PlanRequest& one) { return planner_.plan(one); }, request, waypoint,
                   next);
  }
  std::size_t stepsThrough(const Pose2& start, const Waypoint& waypoint, const Waypoint& next,
                           bool looks_ahead) const {
    const PlanResult first = leg(start, waypoint, looks_ahead ? &next : nullptr);
    const PlanResult second = leg(first.world_from_end, next, nullptr);
    EXPECT_TRUE(first.success() && second.success());
    return first.steps.size() + second.steps.size();
  }

  Planner planner_{arcRepertoire(300, 1), PlannerOptions()};
};

TEST_F(PlanLeg, ArrivesSoThatBothLegsTogetherAreNeverLongerAndSometimesShorter) {
  Random random(4);
  std::size_t with = 0;
  std::size_t without = 0;
  for (int i = 0; i < 20; ++i) {
    const Waypoint waypoint{randomPose(random, 2.0), kAnyHeading};
    const Waypoint next{randomPose(random, 2.0), {0.05, 0.17}};
    const std::size_t looking = stepsThrough({}, waypoint, next, true);
    const std::size_t blind = stepsThrough({}, waypoint, next, false);
    EXPECT_LE(looking, blind);
    with += looking;
    without += blind;
  }
  EXPECT_LT(with, without);
}

TEST_F(PlanLeg, KeepsToTheHeadingThatTheWaypointAsksFor) {
  const Waypoint waypoint{{1.0, 0.0, 0.0}, {0.05, 0.1}};
  const Waypoint next{{1.0, 2.0, 0.0}, kAnyHeading};
  const PlanResult plan = leg({}, waypoint, &next);
  ASSERT_EQ(plan.code, PlanCode::kFound);
  EXPECT_LE(distance(plan.world_from_end, waypoint.world_from_goal), 0.05);
  EXPECT_LE(headingDistance(plan.world_from_end, waypoint.world_from_goal), 0.1);
}

TEST_F(PlanLeg, GoesToAWaypointAfterWhichThereIsNoWay) {
  const Waypoint waypoint{{1.0, 0.0, 0.0}, kAnyHeading};
  const Waypoint nowhere{{std::nan(""), 0.0, 0.0}, kAnyHeading};
  EXPECT_EQ(leg({}, waypoint, &nowhere).code, PlanCode::kFound);
}

TEST_F(PlanLeg, AddsUpToARoute) {
  PlanResult whole;
  const PlanResult first = leg({}, {{1.0, 0.0, 0.0}, kAnyHeading}, nullptr);
  const PlanResult second = leg(first.world_from_end, {{1.0, 1.0, 0.0}, kAnyHeading}, nullptr);
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
