#include "ros_interface/planner/simulated_paths.h"

#include <gtest/gtest.h>

#include <thread>

#include "planning/made_map.h"
#include "self_model/walked_body.h"

namespace hexapod {
namespace {

/// Entries of the shipped robot with end poses as they are walked.
Repertoire walkedRepertoire(const std::string& robot_id) {
  Repertoire repertoire;
  repertoire.run_id = "run";
  repertoire.robot_id = robot_id;
  for (const Genome& gait : walkingGaits()) {
    const SeenBehavior seen = WalkedBody("").walk(gait);
    Entry entry;
    entry.id = static_cast<std::int64_t>(repertoire.entries.size()) + 1;
    entry.genome = gait;
    entry.end_pose = inverse(seen.world_from_before) * seen.world_from_after;
    repertoire.entries.push_back(entry);
  }
  return repertoire;
}

std::shared_ptr<AdaptivePlanner> plannerOf(const Repertoire& repertoire) {
  return std::make_shared<AdaptivePlanner>(repertoire, PlannerOptions(), nullptr);
}

void waitFor(const SimulatedPaths& paths) {
  while (!paths.isDone()) std::this_thread::yield();
}

TEST(SimulatedPaths, TellThePlannerOnWhichWayEachEntryReallyLeads) {
  const Repertoire repertoire = walkedRepertoire(shippedRobot().digest);
  const auto planner = plannerOf(repertoire);
  const auto along_arcs = planner->planner();
  SimulatedPaths paths(shippedRobot());
  EXPECT_TRUE(paths.known(repertoire).front().empty());
  paths.serve(planner);
  waitFor(paths);
  EXPECT_EQ(paths.count(), repertoire.entries.size());
  const EntryPaths known = paths.known(repertoire);
  for (std::size_t i = 0; i < repertoire.entries.size(); ++i) {
    ASSERT_GT(known[i].size(), 10u);
    EXPECT_LT(distance(known[i].back(), repertoire.entries[i].end_pose), 0.01);
  }
  ASSERT_NE(planner->planner(), along_arcs);
  // Beside a post half a metre to the left the planner sees the way itself, without room for arcs.
  const auto post = obstaclesOf(
      [](double x_m, double y_m) { return std::abs(x_m) < 0.1 && std::abs(y_m - 0.8) < 0.1; });
  for (const std::size_t entry : planner->planner()->entries()) {
    double least_m = 1e9;
    for (const Pose2& pose : known[entry]) least_m = std::min(least_m, post->clearance_m(pose));
    EXPECT_NEAR(planner->planner()->clearance_m(*post, {}, entry), least_m, 0.01);
  }
}

TEST(SimulatedPaths, AreNotMadeForAnotherRobotOrOneThatIsNotKnown) {
  const Repertoire repertoire = walkedRepertoire("of another robot");
  const auto planner = plannerOf(repertoire);
  const auto before = planner->planner();
  for (const auto& robot :
       {std::make_optional(shippedRobot()), std::optional<RobotDescription>()}) {
    SimulatedPaths paths(robot);
    paths.serve(planner);
    waitFor(paths);
    EXPECT_EQ(paths.count(), 0u);
  }
  EXPECT_EQ(planner->planner(), before);
}

TEST(SimulatedPaths, AreKeptWhileARepertoireGrowsAndForgottenWithItsRun) {
  Repertoire repertoire = walkedRepertoire(shippedRobot().digest);
  SimulatedPaths paths(shippedRobot());
  paths.serve(plannerOf(repertoire));
  waitFor(paths);
  repertoire.entries.erase(repertoire.entries.begin());
  EXPECT_FALSE(paths.known(repertoire).front().empty());
  paths.serve(plannerOf(repertoire));
  waitFor(paths);
  EXPECT_EQ(paths.count(), repertoire.entries.size());
  repertoire.run_id = "another";
  EXPECT_TRUE(paths.known(repertoire).front().empty());
}

}  // namespace
}  // namespace hexapod
