#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "arc_repertoire.h"
#include "planning/planner.h"

namespace hexapod {
namespace {

PlanResult planTo(const Repertoire& repertoire, const Pose2& goal) {
  PlanRequest request;
  request.world_from_goal = goal;
  const PlanResult plan = Planner(repertoire, PlannerOptions{}).plan(request);
  EXPECT_FALSE(plan.message.empty());
  if (plan.code == PlanCode::kFound) {
    EXPECT_LE(distance(plan.world_from_end, goal), 0.05);
    EXPECT_LE(headingDistance(plan.world_from_end, goal), 0.17);
  }
  return plan;
}

Repertoire only(const std::function<bool(const Pose2&)>& wanted) {
  std::vector<Entry> entries;
  for (const Entry& entry : arcRepertoire(400, 1).entries) {
    if (wanted(entry.end_pose)) entries.push_back(entry);
  }
  return repertoireOf(std::move(entries));
}

TEST(OddRepertoire, WithoutEntriesSaysSo) {
  EXPECT_EQ(planTo(Repertoire{}, {1.0, 0.0, 0.0}).code, PlanCode::kNoRepertoire);
}

TEST(OddRepertoire, OfEntriesThatFellOrStandStillOrAreNotFiniteSaysSo) {
  Entry fell = entryTo({0.5, 0.0, 0.0});
  fell.execution->falls = 1;
  Entry untried = entryTo({0.5, 0.0, 0.0});
  untried.execution->trials = 0;
  const Entry still = entryTo({0.001, 0.0, 0.001});
  const Entry broken = entryTo({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0});
  const PlanResult plan = planTo(repertoireOf({fell, untried, still, broken}), {0.5, 0.0, 0.0});
  EXPECT_EQ(plan.code, PlanCode::kNoRepertoire);
  EXPECT_NE(plan.message.find("4 entries"), std::string::npos);
}

TEST(OddRepertoire, NeverUsesAnEntryThatFell) {
  Repertoire repertoire = arcRepertoire(300, 3);
  for (std::size_t i = 0; i < repertoire.entries.size(); i += 2) {
    repertoire.entries[i].execution->falls = 1;
  }
  Random random(4);
  const Planner planner(repertoire, PlannerOptions{});
  EXPECT_EQ(planner.usableEntries(), 150u);
  for (int i = 0; i < 50; ++i) {
    PlanRequest request;
    request.world_from_goal = {random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0), 0.0};
    for (const PlannedStep& step : planner.plan(request).steps) EXPECT_EQ(step.entry % 2, 1u);
  }
}

TEST(OddRepertoire, OfUnvalidatedEntriesIsPlannedAsLearned) {
  Repertoire repertoire = arcRepertoire(200, 5);
  for (Entry& entry : repertoire.entries) entry.execution.reset();
  EXPECT_EQ(planTo(repertoire, {0.8, 0.4, 1.0}).code, PlanCode::kFound);
}

TEST(OddRepertoire, OfOneStepForwardReachesMultiplesOfIt) {
  const Repertoire repertoire = repertoireOf({entryTo({0.3, 0.0, 0.0})});
  EXPECT_EQ(planTo(repertoire, {0.9, 0.0, 0.0}).steps.size(), 3u);
  EXPECT_EQ(planTo(repertoire, {3.0, 0.0, 0.0}).steps.size(), 10u);
  const PlanResult between = planTo(repertoire, {0.73, 0.0, 0.0});
  EXPECT_EQ(between.code, PlanCode::kUnreachable);
  EXPECT_NEAR(between.world_from_end.x_m, 0.6, 1e-9);
  EXPECT_NEAR(between.distance_m, 0.13, 1e-9);
  EXPECT_EQ(planTo(repertoire, {-0.3, 0.0, 0.0}).code, PlanCode::kUnreachable);
}

TEST(OddRepertoire, OfOneLeftArcReachesItsCircle) {
  // Six chords of a hexagon lead back to the start.
  const Pose2 chord = {0.3 * std::cos(M_PI / 6), 0.3 * std::sin(M_PI / 6), M_PI / 3};
  const Repertoire repertoire = repertoireOf({entryTo(chord)});
  EXPECT_EQ(planTo(repertoire, chord * chord * chord * chord).steps.size(), 4u);
  EXPECT_EQ(planTo(repertoire, {0.0, 0.3, 0.0}).code, PlanCode::kUnreachable);
}

TEST(OddRepertoire, OfOneTurnInPlaceTurns) {
  const Repertoire repertoire = repertoireOf({entryTo({0.0, 0.0, 0.5})});
  EXPECT_EQ(planTo(repertoire, {0.0, 0.0, 2.0}).steps.size(), 4u);
  EXPECT_EQ(planTo(repertoire, {0.0, 0.0, -1.8}).steps.size(), 9u);  // 4.48 rad to the left
  EXPECT_EQ(planTo(repertoire, {0.5, 0.0, 0.0}).code, PlanCode::kUnreachable);
}

TEST(OddRepertoire, OfTinyStepsGetsThere) {
  const Repertoire repertoire = repertoireOf(
      {entryTo({0.03, 0.0, 0.0}), entryTo({0.02, 0.0, 0.08}), entryTo({0.02, 0.0, -0.08})});
  EXPECT_EQ(planTo(repertoire, {0.6, 0.1, 0.0}).code, PlanCode::kFound);
}

TEST(OddRepertoire, OfForwardStepsGetsBehind) {
  const Repertoire repertoire = only([](const Pose2& end) { return end.x_m > 0.0; });
  EXPECT_EQ(planTo(repertoire, {1.0, 0.5, 0.5}).code, PlanCode::kFound);
  EXPECT_EQ(planTo(repertoire, {-0.5, 0.0, 0.0}).code, PlanCode::kFound);
  EXPECT_EQ(planTo(repertoire, {0.0, 0.2, 0.0}).code, PlanCode::kFound);
  EXPECT_EQ(planTo(repertoire, {-4.0, 0.0, 0.0}).code, PlanCode::kFound);
}

TEST(OddRepertoire, OfLeftTurnsGetsToTheRight) {
  const Repertoire repertoire = only([](const Pose2& end) { return end.yaw_rad > 0.1; });
  EXPECT_EQ(planTo(repertoire, {0.5, -0.5, -1.0}).code, PlanCode::kFound);
  EXPECT_EQ(planTo(repertoire, {3.0, -1.0, 0.0}).code, PlanCode::kFound);
}

TEST(OddRepertoire, OfForwardLeftTurnsGetsToTheRight) {
  const Repertoire repertoire =
      only([](const Pose2& end) { return end.x_m > 0.0 && end.yaw_rad > 0.1; });
  EXPECT_EQ(planTo(repertoire, {0.5, -0.5, -1.0}).code, PlanCode::kFound);
  EXPECT_EQ(planTo(repertoire, {3.0, -1.0, 0.0}).code, PlanCode::kFound);
}

TEST(OddRepertoire, OfSidestepsGetsAside) {
  const Repertoire repertoire =
      repertoireOf({entryTo({0.0, 0.2, 0.0}), entryTo({0.0, -0.2, 0.0}), entryTo({0.2, 0.0, 0.0})});
  EXPECT_EQ(planTo(repertoire, {0.8, -1.0, 0.0}).steps.size(), 9u);
}

TEST(OddRepertoire, OfNinePrimitivesOfAWheeledRobotGetsAnywhere) {
  const Repertoire repertoire = repertoireOf(
      {entryTo({0.05, 0.0, 0.0}), entryTo({0.4, 0.0, 0.0}), entryTo({-0.05, 0.0, 0.0}),
       entryTo({0.4, 0.1, 0.39}), entryTo({0.4, -0.1, -0.39}), entryTo({-0.4, 0.1, -0.39}),
       entryTo({-0.4, -0.1, 0.39}), entryTo({0.0, 0.0, 0.39}), entryTo({0.0, 0.0, -0.39})});
  for (const Pose2& goal : {Pose2{1.0, 0.5, 0.0}, Pose2{-1.0, 0.2, 3.0}, Pose2{0.0, 0.7, 1.5},
                            Pose2{2.0, -2.0, -0.8}}) {
    EXPECT_EQ(planTo(repertoire, goal).code, PlanCode::kFound);
  }
}

TEST(OddRepertoire, WithAnAbsurdlyFarEntryStillPlans) {
  Repertoire repertoire = arcRepertoire(100, 6);
  repertoire.entries.push_back(entryTo({1e6, -1e6, 0.0}));
  EXPECT_EQ(planTo(repertoire, {1.0, 0.5, 0.5}).code, PlanCode::kFound);
}

}  // namespace
}  // namespace hexapod
