#include "ros_interface/planner/tally_keeper.h"

#include <gtest/gtest.h>

#include "ros_interface/fake_clock.h"

namespace hexapod {
namespace {

PlanResult planOf(const std::vector<std::size_t>& entries) {
  PlanResult plan;
  for (const std::size_t entry : entries) plan.steps.push_back({entry, 0, {}});
  return plan;
}

TEST(TallyKeeper, AddsUpAWalk) {
  FakeClock clock;
  TallyKeeper keeper(clock);
  keeper.noteRest({0.0, 0.0, 0.0});
  keeper.noteClearance(0.4);
  clock.pass(4 * kSecond_ns);
  keeper.noteRest({0.3, 0.4, 0.0});
  keeper.noteStep({0.3, 0.36, 0.1}, {0.3, 0.4, 0.0});
  keeper.noteClearance(0.1);
  clock.setRos(3600.0);  // a wall clock that somebody sets
  clock.pass(4 * kSecond_ns);
  keeper.noteRest({0.3, 0.9, 0.0});
  keeper.noteStep({0.3, 0.88, -0.3}, {0.3, 0.9, 0.0});
  keeper.noteClearance(0.2);
  const WalkTally tally = keeper.tally();
  EXPECT_NEAR(tally.duration_s, 8.0, 1e-9);
  EXPECT_NEAR(tally.distance_m, 0.5 + 0.5, 1e-12);
  EXPECT_EQ(tally.measured, 2u);
  EXPECT_NEAR(tally.xy_error_m, (0.04 + 0.02) / 2.0, 1e-12);
  EXPECT_NEAR(tally.yaw_error_rad, (0.1 + 0.3) / 2.0, 1e-12);
  EXPECT_EQ(tally.clearance_m, 0.1);
}

TEST(TallyKeeper, CountsPlansThatAreNotWhatWasLeftOfTheOneBefore) {
  FakeClock clock;
  TallyKeeper keeper(clock);
  keeper.notePlan(planOf({1, 2, 3}));
  EXPECT_EQ(keeper.tally().replans, 0u);
  keeper.notePlan(planOf({2, 3}));
  EXPECT_EQ(keeper.tally().replans, 0u);
  keeper.notePlan(planOf({4}));
  EXPECT_EQ(keeper.tally().replans, 1u);
  keeper.notePlan(planOf({}));
  EXPECT_EQ(keeper.tally().replans, 1u);
  keeper.notePlan(planOf({5, 6}));
  EXPECT_EQ(keeper.tally().replans, 2u);
}

}  // namespace
}  // namespace hexapod
