#include "ros_interface/planner/walk_means.h"

#include <gtest/gtest.h>

#include "planning/arc_repertoire.h"
#include "planning/random_goal.h"
#include "ros_interface/fake_clock.h"

namespace hexapod {
namespace {

TEST(WithinWallTime, EndsAPlanWhenItsTimeByTheClockIsUp) {
  PlannerNodeOptions options;
  options.planning_wall_time_s = 0.5;
  FakeClock clock;
  PlanRequest request = requestTo({15.0, 3.0, 1.0});
  const Planner planner(arcRepertoire(300, 1), PlannerOptions());
  request.stop = withinWallTime(options, clock, {});
  EXPECT_TRUE(planner.plan(request).success());
  clock.pass(kSecond_ns);
  EXPECT_EQ(planner.plan(request).code, PlanCode::kTimeout);
  request.stop = withinWallTime(options, clock, {});
  EXPECT_TRUE(planner.plan(request).success()) << "the time begins with the plan";
}

TEST(WithinWallTime, LeavesOnlyTheCallerToStopWithoutOne) {
  PlannerNodeOptions options;
  options.planning_wall_time_s = 0.0;
  FakeClock clock;
  bool cancelled = false;
  const auto stop = withinWallTime(options, clock, [&] { return cancelled; });
  clock.pass(1000 * kSecond_ns);
  EXPECT_FALSE(stop());
  cancelled = true;
  EXPECT_TRUE(stop());
}

}  // namespace
}  // namespace hexapod
