#include "ros_interface/panel/panel_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "repertoire/fixtures.h"
#include "ros_interface/common/conversions.h"

namespace hexapod {
namespace {

using hexapod_repertoire::ExecutorState;

hexapod_repertoire::LearningProgress progress(std::int64_t evaluations, const std::string& phase) {
  hexapod_repertoire::LearningProgress message;
  message.run_id = "run";
  message.phase = phase;
  message.evaluations = evaluations;
  message.evaluations_budget = 1000;
  message.archive_size = 10;
  message.sparseness_m = 0.02;
  message.median_orientation_error_rad = M_PI / 180.0;
  return message;
}

ExecutorState executor(std::uint8_t state) {
  ExecutorState message;
  message.state = state;
  message.reason = "Because.";
  return message;
}

PanelModel withEverybody() {
  PanelModel model;
  model.setPresence({true, true, true, true});
  return model;
}

TEST(PanelModel, OffersStartWhilePausedAndPauseWhileLearningAndNeitherInTheEnd) {
  PanelModel model = withEverybody();
  EXPECT_FALSE(model.offers(Ask::kStart) || model.offers(Ask::kPause) || model.offers(Ask::kSave));
  model.hearProgress(progress(0, "paused"));
  EXPECT_TRUE(model.offers(Ask::kStart));
  EXPECT_FALSE(model.offers(Ask::kPause));
  model.hearProgress(progress(10, "evolving"));
  EXPECT_FALSE(model.offers(Ask::kStart));
  EXPECT_TRUE(model.offers(Ask::kPause));
  model.hearProgress(progress(1000, "done"));
  EXPECT_FALSE(model.offers(Ask::kStart) || model.offers(Ask::kPause));
  EXPECT_TRUE(model.offers(Ask::kSave));
  model.setPresence({});
  EXPECT_FALSE(model.offers(Ask::kSave));
}

TEST(PanelModel, ShowsTheCurveFromBeforeItCameWhetherItHearsOfThatFirstOrLast) {
  hexapod_repertoire::LearningHistory history;
  history.run_id = "run";
  history.evaluations = {100, 200};
  history.sparseness_m = {0.05, 0.03};
  history.median_orientation_error_rad = {0.2, M_PI / 90.0};
  for (const bool first : {true, false}) {
    PanelModel model = withEverybody();
    if (first) model.hearHistory(history);
    model.hearProgress(progress(200, "evolving"));
    model.hearProgress(progress(300, "evolving"));
    if (!first) model.hearHistory(history);
    ASSERT_EQ(model.curve().size(), 3u);
    EXPECT_EQ(model.curve()[0].evaluations, 100.0);
    EXPECT_NEAR(model.curve()[1].sparseness_cm, 3.0, 1e-9);
    EXPECT_NEAR(model.curve()[1].error_deg, 2.0, 1e-9);
    EXPECT_EQ(model.curve()[2].evaluations, 300.0);
  }
}

TEST(PanelModel, ForgetsTheCurveOfAnotherRun) {
  PanelModel model = withEverybody();
  model.hearProgress(progress(200, "evolving"));
  hexapod_repertoire::LearningHistory other;
  other.run_id = "other";
  model.hearHistory(other);
  EXPECT_TRUE(model.curve().empty());
}

TEST(PanelModel, KnowsTheEntryBelowTheMouseUnlessTheFilterLeavesItOut) {
  PanelModel model = withEverybody();
  EXPECT_FALSE(model.entryAt(0.0, 0.0));
  const Repertoire repertoire = sampleRepertoire(20);
  model.hearRepertoire(toMsg(repertoire, ros::Time(1.0)));
  const Entry& entry = repertoire.entries.at(3);
  const Pose2& end = entry.expectedPose();
  ASSERT_TRUE(model.entryAt(end.x_m, end.y_m));
  EXPECT_EQ(model.entryAt(end.x_m, end.y_m)->id, entry.id);
  EXPECT_FALSE(model.entryAt(100.0, 0.0));
  model.setFilter({-1.0, -1.0});
  EXPECT_FALSE(model.entryAt(end.x_m, end.y_m));
}

TEST(PanelModel, OffersArmWhenNothingIsSentAndSitWhenReadyAndStopAlways) {
  PanelModel model = withEverybody();
  for (const auto state : {ExecutorState::DISARMED, ExecutorState::STOPPED, ExecutorState::FAULT}) {
    model.hearExecutor(executor(state));
    EXPECT_TRUE(model.offers(Ask::kArm) && model.offers(Ask::kStop));
    EXPECT_FALSE(model.offers(Ask::kSit) || model.offers(Ask::kGo));
  }
  model.hearExecutor(executor(ExecutorState::READY));
  EXPECT_TRUE(model.offers(Ask::kSit) && model.offers(Ask::kGo) && model.offers(Ask::kStop));
  EXPECT_FALSE(model.offers(Ask::kArm));
  model.setPresence({});
  EXPECT_TRUE(model.offers(Ask::kStop));
  EXPECT_FALSE(model.offers(Ask::kSit) || model.offers(Ask::kGo) || model.offers(Ask::kCancel));
}

TEST(PanelModel, KeepsACurveOfTheRunAndBeginsAnewWithTheNext) {
  PanelModel model = withEverybody();
  for (const int evaluations : {100, 200, 200, 300}) {
    model.hearProgress(progress(evaluations, "evolving"));
  }
  ASSERT_EQ(model.curve().size(), 3u);
  EXPECT_DOUBLE_EQ(model.curve()[1].evaluations, 200.0);
  EXPECT_DOUBLE_EQ(model.curve()[1].sparseness_cm, 2.0);
  EXPECT_NEAR(model.curve()[1].error_deg, 1.0, 1e-12);
  auto other = progress(50, "evolving");
  other.run_id = "another";
  model.hearProgress(other);
  ASSERT_EQ(model.curve().size(), 1u);
}

TEST(PanelModel, ListsTheEntriesThatPassTheFilter) {
  Repertoire repertoire = sampleRepertoire();
  ASSERT_GE(repertoire.entries.size(), 3u);
  repertoire.entries[0].execution = Execution{repertoire.entries[0].end_pose, 0.05, 0.0, 4, 0};
  repertoire.entries[1].execution = Execution{repertoire.entries[1].end_pose, 0.001, 0.0, 4, 0};
  repertoire.entries[2].execution.reset();
  PanelModel model = withEverybody();
  model.hearRepertoire(toMsg(repertoire, ros::Time()));
  EXPECT_EQ(model.entries().size(), repertoire.entries.size());
  const int before = model.entriesRevision();
  model.setFilter({M_PI, 0.01});
  EXPECT_GT(model.entriesRevision(), before);
  std::vector<std::int64_t> ids;
  for (const auto& line : model.entries()) ids.push_back(line.id);
  EXPECT_EQ(std::count(ids.begin(), ids.end(), repertoire.entries[0].id), 0);
  EXPECT_EQ(std::count(ids.begin(), ids.end(), repertoire.entries[1].id), 1);
  // What was not validated has no spread that could be too large.
  EXPECT_EQ(std::count(ids.begin(), ids.end(), repertoire.entries[2].id), 1);
  model.setFilter({-1.0, 1.0});
  EXPECT_TRUE(model.entries().empty());
}

TEST(PanelModel, TellsOfEveryNodeItsStateAndWhy) {
  PanelModel model = withEverybody();
  model.hearExecutor(executor(ExecutorState::FAULT));
  diagnostic_msgs::DiagnosticArray diagnostics;
  diagnostics.status.resize(1);
  diagnostics.status[0].name = "simulated_robot: Commands";
  diagnostics.status[0].level = diagnostic_msgs::DiagnosticStatus::WARN;
  diagnostics.status[0].message = "None for a while.";
  model.hearDiagnostics(diagnostics);
  const auto lines = model.nodes();
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(lines[1].name, "executor");
  EXPECT_EQ(lines[1].state, "fault");
  EXPECT_EQ(lines[1].reason, "Because.");
  EXPECT_FALSE(lines[1].is_well);
  EXPECT_EQ(lines[4].reason, "None for a while.");
  EXPECT_FALSE(lines[4].is_well);
  model.setPresence({});
  EXPECT_EQ(model.nodes()[1].state, "not here");
}

TEST(PanelModel, TellsOfARepertoireThatCannotBeRead) {
  hexapod_repertoire::Repertoire message = toMsg(sampleRepertoire(), ros::Time());
  message.entries[0].genome[0] = 9;
  PanelModel model = withEverybody();
  model.hearRepertoire(message);
  EXPECT_NE(model.repertoireSentence().find("entry"), std::string::npos);
}

}  // namespace
}  // namespace hexapod
