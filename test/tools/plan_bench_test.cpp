#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tools/bench_plan_options.h"
#include "tools/plan_trial.h"
#include "tools/touch_check.h"

namespace hexapod {
namespace {

/// 4 x 4 cells of 0.5 m from the origin; the one at column 3, row 1 is occupied.
OccupancyMap oneOccupied() {
  OccupancyMap map;
  map.resolution_m = 0.5;
  map.columns = map.rows = 4;
  map.cells.assign(16, 0);
  map.cells[1 * 4 + 3] = 100;
  return map;
}

TEST(TouchCheck, MeasuresFromTheRimOfADiscToTheNearestPointOfACell) {
  const OccupancyMap map = oneOccupied();  // occupied: 1.5 .. 2.0 by 0.5 .. 1.0
  const TouchCheck check(map);
  EXPECT_NEAR(check.clearance_m({0.7, 0.8, 0.3}, 1.0), 0.8 - 0.3, 1e-12);
  // 0.3 to the left of its corner, 0.4 above it.
  EXPECT_NEAR(check.clearance_m({1.2, 1.4, 0.2}, 1.0), 0.5 - 0.2, 1e-12);
  EXPECT_NEAR(check.clearance_m({1.7, 0.7, 0.1}, 1.0), -0.1, 1e-12) << "within the cell";
  EXPECT_EQ(check.clearance_m({0.2, 0.2, 0.1}, 0.4), 0.4) << "nothing within what is looked at";
}

TEST(TouchCheck, SeesWhatIsTouchedBetweenTwoPoses) {
  OccupancyMap map = oneOccupied();
  map.world_from_map = {10.0, 0.0, 0.0};
  const TouchCheck check(map);
  const std::vector<Disc> disc = {{0.0, 0.0, 0.1}};
  // Past the cell 0.15 m above it: the ends are far from it.
  const std::vector<Pose2> past = {{11.0, 1.15, 0.0}, {13.0, 1.15, 0.0}};
  EXPECT_NEAR(check.clearanceAlong_m(past, disc, 1.0), 0.05, 1e-3);
  const std::vector<Pose2> through = {{11.0, 0.9, 0.0}, {13.0, 0.9, 0.0}};
  EXPECT_LT(check.clearanceAlong_m(through, disc, 1.0), -0.05);
}

TEST(MadeWorlds, AreTheSameForTheSameSeedAndWalledIn) {
  for (const WorldKind& kind : openWorldKinds()) {
    const OccupancyMap world = makeWorldOf(kind, 5);
    EXPECT_EQ(world.cells, makeWorldOf(kind, 5).cells) << kind.name;
    EXPECT_NE(world.cells, makeWorldOf(kind, 6).cells) << kind.name;
    for (int i = 0; i < world.columns; ++i) {
      EXPECT_GE(std::min({world.at(i, 0), world.at(i, world.rows - 1), world.at(0, i),
                          world.at(world.columns - 1, i)}),
                OccupancyMap::kOccupied)
          << kind.name;
    }
  }
}

TEST(PlanTasks, HaveStartsAndGoalsThatAreConnectedOrNotAsTheirWorldSays) {
  const Footprint footprint{{{0.0, 0.0, 0.3}}};
  const ObstacleOptions options;
  const double radius_m = 0.3 + options.footprint_margin_m;
  for (const WorldKind& kind : {openWorldKinds().front(), closedWorldKind()}) {
    const bool is_open = kind.name == openWorldKinds().front().name;
    const auto tasks = tasksIn(kind, 20, {0.02, 0.05}, footprint, options, 3);
    ASSERT_EQ(tasks.size(), 20u);
    std::set<const OccupancyMap*> worlds;
    for (const PlanTask& task : tasks) {
      worlds.insert(task.map.get());
      EXPECT_EQ(isConnected(task, radius_m), is_open) << kind.name;
      const TouchCheck check(*task.map);
      for (const Pose2& pose : {task.request.world_from_start, task.request.world_from_goal}) {
        EXPECT_GE(check.clearance_m(pose, footprint.grownBy(options.footprint_margin_m).discs, 1.0),
                  -1e-9);
      }
    }
    EXPECT_EQ(worlds.size(), 10u);
  }
}

TEST(DescribePlanTrials, CountsFoundProvedAndTouched) {
  PlanTrial proved;
  proved.plan.code = PlanCode::kFound;
  proved.plan.steps.resize(2);
  proved.plan.at_least_steps = 2;
  proved.touch_m = 0.05;
  PlanTrial touching = proved;
  touching.plan.at_least_steps = 1;
  touching.touch_m = -0.01;
  proved.predicted = {0.003, 0.001, true};
  proved.missed = {0.004, 0.002, true};
  PlanTrial none;
  none.plan.code = PlanCode::kBlocked;
  const std::string line = describe("a world", {proved, touching, none});
  EXPECT_EQ(line,
            "| a world | 2 of 3 | 0.0 / 0.0 | 0.0 / 0.0 / 0.0 | 2.00 | 1 | 1.33 | 1.00 | 3.0 | "
            "2.00 | 2.0 | 1 | -1.0 |\n");
}

TEST(BenchPlanOptions, NeedARepertoireAndNameWhatTheyDoNotKnow) {
  EXPECT_THROW(benchPlanOptionsFrom({"--walks", "3"}), std::invalid_argument);
  EXPECT_THROW(benchPlanOptionsFrom({"--repertoire", "a.db", "--wlaks", "3"}),
               std::invalid_argument);
  const BenchPlanOptions options = benchPlanOptionsFrom({"--repertoire", "a.db", "--walks", "3"});
  EXPECT_EQ(options.walks, 3);
  EXPECT_TRUE(benchPlanOptionsFrom({"--help"}).help);
}

}  // namespace
}  // namespace hexapod
