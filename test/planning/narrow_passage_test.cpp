#include <gtest/gtest.h>

#include <memory>

#include "arc_repertoire.h"
#include "made_map.h"
#include "planning/planner.h"
#include "random_goal.h"

namespace hexapod {
namespace {

/// Moves straight ahead and back whose ways are known to be straight.
class NarrowPassage : public testing::Test {
 protected:
  NarrowPassage() {
    std::vector<Entry> entries;
    EntryPaths paths;
    for (const double length_m : {0.5, 0.3, 0.2, 0.1, -0.1, -0.3}) {
      entries.push_back(entryTo({length_m, 0.0, 0.0}));
      paths.push_back({{0.5 * length_m, 0.0, 0.0}, {length_m, 0.0, 0.0}});
    }
    planner_ = std::make_unique<Planner>(repertoireOf(entries), PlannerOptions(), paths);
  }

  /// The plan through a passage of that width, 30 cm long, for a disc of 0.3 m.
  PlanRequest through(double width_m, const ObstacleOptions& options = {}) const {
    PlanRequest request = requestTo({2.3, 0.0, 0.0});
    request.obstacles = std::make_shared<const Obstacles>(mapOf([=](double x_m, double y_m) {
                                                            return x_m > 1.0 && x_m < 1.3 &&
                                                                   std::abs(y_m) > 0.5 * width_m;
                                                          }),
                                                          Footprint{{{0.0, 0.0, 0.3}}}, options);
    return request;
  }

  std::unique_ptr<Planner> planner_;
};

TEST_F(NarrowPassage, IsWalkedThroughWithTheNarrowMarginWhereTheWholeOneLeavesNoWay) {
  const PlanResult wide = planner_->plan(through(0.9));
  EXPECT_EQ(wide.code, PlanCode::kFound) << wide.message;
  EXPECT_FALSE(wide.memory.is_narrow);
  const PlanRequest request = through(0.7);
  const PlanResult narrow = planner_->plan(request);
  ASSERT_EQ(narrow.code, PlanCode::kFound) << narrow.message;
  EXPECT_TRUE(narrow.memory.is_narrow);
  // The footprint itself, 5 cm from the wall, keeps its narrow margin all along.
  for (const PlannedStep& step : narrow.steps) {
    EXPECT_GE(request.obstacles->narrow()->clearance_m(step.world_from_end), 0.0);
  }
  EXPECT_GE(narrow.clearance_m, 0.0);
}

TEST_F(NarrowPassage, IsNoWayWhereNotEvenTheNarrowMarginFits) {
  ObstacleOptions walled_in;
  walled_in.unknown_is_free = false;
  EXPECT_EQ(planner_->plan(through(0.5, walled_in)).code, PlanCode::kBlocked);
  ObstacleOptions strict;
  strict.narrow_margin_m = strict.footprint_margin_m;
  EXPECT_FALSE(planner_->plan(through(0.7, strict)).success());
}

TEST_F(NarrowPassage, IsFoundAtAnyResolutionAndOriginOfTheMap) {
  ObstacleOptions strict;
  strict.narrow_margin_m = strict.footprint_margin_m;
  strict.unknown_is_free = false;
  Random random(1);
  for (const double resolution_m : {0.02, 0.05, 0.07, 0.1}) {
    // As many cells as the disc with its margin, 0.66 m wide, and a centimetre beside it take.
    const int free = static_cast<int>(std::ceil(0.68 / resolution_m - 1e-9));
    OccupancyMap map =
        passageOf(free, static_cast<int>(std::lround(4.0 / resolution_m)), resolution_m);
    for (int i = 0; i < 5; ++i) {
      map.world_from_map = randomPose(random, 20.0);
      const double middle_m = 0.5 * map.rows * resolution_m;
      PlanRequest request;
      request.world_from_start = map.world_from_map * Pose2{0.7, middle_m, 0.0};
      request.world_from_goal = map.world_from_map * Pose2{3.2, middle_m, 0.0};
      request.obstacles =
          std::make_shared<const Obstacles>(map, Footprint{{{0.0, 0.0, 0.3}}}, strict);
      const PlanResult plan = planner_->plan(request);
      ASSERT_EQ(plan.code, PlanCode::kFound) << resolution_m << " m: " << plan.message;
      EXPECT_GE(plan.clearance_m, 0.005);
    }
  }
}

TEST_F(NarrowPassage, StaysPlannedThroughOnTheWay) {
  PlanRequest request = through(0.7);
  const PlanResult first = planner_->plan(request);
  ASSERT_EQ(first.code, PlanCode::kFound) << first.message;
  request.world_from_start = first.steps.front().world_from_end;
  request.memory = first.memory;
  const PlanResult second = planner_->plan(request);
  ASSERT_EQ(second.code, PlanCode::kFound) << second.message;
  EXPECT_TRUE(second.memory.is_narrow);
  EXPECT_EQ(second.memory.ways, first.memory.ways) << "the ways were looked for again";
  ASSERT_EQ(second.steps.size() + 1, first.steps.size());
  EXPECT_EQ(second.steps.front().id, first.steps[1].id);
}

}  // namespace
}  // namespace hexapod
