#include "learning/progress_display.h"

#include <gtest/gtest.h>

#include <sstream>

#include "learning/learning_report.h"

namespace hexapod {
namespace {

LearningStatus halfDone() {
  LearningStatus status;
  status.counters.evaluations = 2000;
  status.evaluations_budget = 4000;
  status.entries = 120;
  status.evaluations_per_s = 512.4;
  status.left_s = 3.9;
  status.last.evaluations = 2000;
  status.simulations = 2500;
  status.known = 130;
  status.last.sparseness_m = 0.0421;
  status.last.median_orientation_error_rad = 0.0403;  // 2.31 degrees
  return status;
}

LearningStatus validating(std::int64_t validated) {
  LearningStatus status = halfDone();
  status.phase = LearningPhase::kValidating;
  status.checked = validated;
  status.to_check = 120;
  return status;
}

TEST(LearningReport, TellsOfTrialsOnTheRobotWhereThereAreAny) {
  LearningStatus status = halfDone();
  status.trials = 12;
  EXPECT_EQ(
      describe(status),
      "Learning: 2000 of 4000, trained: sparseness 4.21 cm, 2.31 deg, 120 entries, 12 tried on "
      "the robot, 4 s left");
  status.phase = LearningPhase::kTransferring;
  EXPECT_EQ(describe(status),
            "Transferring: what 12 trials tell of where the robot takes the entries");
  EXPECT_EQ(describeBriefly(status), describe(status));
}

TEST(LearningReport, TellsRateTimeLeftAndBothMetrics) {
  EXPECT_EQ(describe(halfDone()),
            "Learning: 2000 of 4000, trained: sparseness 4.21 cm, 2.31 deg, 120 entries, 4 s left");
  EXPECT_EQ(describe(validating(30)), "Validating: 30 of 120 executions, 4 s left");
}

TEST(LearningReport, LeavesOutTheMetricsUntilThereAreSome) {
  LearningStatus status = halfDone();
  status.last = HistoryRow();
  EXPECT_EQ(describe(status), "Learning: 2000 of 4000, 120 entries, 4 s left");
}

TEST(LearningReport, MeasuresTheBudgetThatIsUsedUpFirst) {
  LearningStatus status = halfDone();
  EXPECT_EQ(fractionDone(status), 0.5);
  status.time_budget_s = 8.0;
  status.elapsed_s = 6.0;
  EXPECT_EQ(fractionDone(status), 0.75);
  EXPECT_EQ(fractionDone(validating(30)), 0.25);
  EXPECT_EQ(fractionDone(LearningStatus()), 1.0);
}

TEST(ProgressBar, FillsWithTheBudget) {
  const std::string bar = progressBar(halfDone(), 200);
  EXPECT_EQ(bar, "[##...]  50 %  trained: sparseness 4.21 cm, 2.31 deg, 120 entries, 4 s left");
}

TEST(ProgressBar, FitsItsTerminal) {
  LearningStatus large = halfDone();
  large.entries = 9999;
  large.left_s = 5999.0;
  EXPECT_EQ(progressBar(large, 79), progressBar(large, 200));
  EXPECT_EQ(progressBar(halfDone(), 40).size(), 40U);
  EXPECT_EQ(progressBar(halfDone(), 0), "");
}

TEST(ProgressDisplay, WritesPlainLinesEveryPeriodAndAtEachChangeOfPhase) {
  std::ostringstream out;
  ProgressDisplay display(out, {false, 80, 5.0});
  display.show(halfDone(), 100.0);
  display.show(halfDone(), 104.0);
  EXPECT_EQ(out.str(), describe(halfDone()) + "\n");
  out.str("");
  display.show(halfDone(), 105.0);
  display.show(validating(1), 105.1);
  display.show(validating(2), 105.2);
  EXPECT_EQ(out.str(), describe(halfDone()) + "\n" + describe(validating(1)) + "\n");
}

TEST(ProgressDisplay, RedrawsTheBarInPlaceOnATerminal) {
  std::ostringstream out;
  ProgressDisplay display(out, {true, 80, 5.0});
  display.show(halfDone(), 1.0);
  display.show(halfDone(), 2.0);
  const std::string once = "\r\x1b[K" + progressBar(halfDone(), 79) + "\r";
  EXPECT_EQ(out.str(), once + once);
}

TEST(ProgressDisplay, TakesTheBarAwayBeforeALineOfSomebodyElse) {
  std::ostringstream bar;
  std::string lines;
  ProgressDisplay display(bar, {true, 80, 5.0}, [&](const std::string& line) {
    EXPECT_EQ(bar.str().substr(bar.str().size() - 4), "\r\x1b[K");
    lines += line;
  });
  display.show(halfDone(), 1.0);
  display.say("Saved.");
  EXPECT_EQ(lines, "Saved.");
}

TEST(ProgressDisplay, RepeatsAComplaintSlowly) {
  std::ostringstream out;
  ProgressDisplay display(out, {false, 80, 5.0});
  display.complain("The disk is full.", 1.0);
  const std::string once = out.str();
  EXPECT_NE(once.find("ERROR: The disk is full."), std::string::npos);
  display.complain("The disk is full.", 10.0);
  EXPECT_EQ(out.str(), once);
  display.complain("The disk is full.", 11.5);
  EXPECT_EQ(out.str(), once + once);
}

}  // namespace
}  // namespace hexapod
