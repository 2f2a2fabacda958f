#include "calibration/trial_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "calibration/calibration_report.h"
#include "made_trials.h"

namespace hexapod {
namespace {

class TrialFile : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file_); }

  std::string complaint(const std::string& line) const {
    std::ofstream(file_) << "names\n" << line << "\n";
    try {
      readTrials(file_, 4);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  const std::string file_ =
      (std::filesystem::path(testing::TempDir()) / "hexapod_trial_file.csv").string();
};

TEST_F(TrialFile, ReadsBackWhatItWrote) {
  std::vector<Trial> trials(2);
  trials[0].seen = {{0, 1, 2, 3}, {0.1, -0.2, 1.0 / 3.0}, {1e-9, 2.0, -3.0}, {}};
  trials[1].is_check = true;
  trials[1].seen.genome = {4, 4, 4, 4};
  writeTrials(trials, file_);
  const std::vector<Trial> again = readTrials(file_, 4);
  ASSERT_EQ(again.size(), 2u);
  EXPECT_FALSE(again[0].is_check);
  EXPECT_TRUE(again[1].is_check);
  EXPECT_EQ(again[0].seen.genome, trials[0].seen.genome);
  EXPECT_EQ(again[0].seen.world_from_before.yaw_rad, 1.0 / 3.0);
  EXPECT_EQ(again[0].seen.world_from_after.x_m, 1e-9);
}

TEST_F(TrialFile, WritesAPlanForARobotsOwnPrograms) {
  std::vector<Trial> trials(1);
  trials[0].seen.genome = {0, 1, 2, 3};
  writePlan(trials, file_);
  std::ifstream stream(file_);
  std::ostringstream text;
  text << stream.rdbuf();
  EXPECT_EQ(text.str(), "use,genome\nfit,0123\n");
}

TEST_F(TrialFile, NamesLineAndValueThatAreWrong) {
  EXPECT_NE(complaint("fit,0123,0,0,0,0,0").find("line 2: expected 8 values, found 7"),
            std::string::npos);
  EXPECT_NE(complaint("try,0123,0,0,0,0,0,0").find("expected fit or check, found 'try'"),
            std::string::npos);
  EXPECT_NE(complaint("fit,0123,0,0,east,0,0,0").find("found 'east'"), std::string::npos);
  EXPECT_NE(complaint("fit,09z3,0,0,0,0,0,0").find("line 2"), std::string::npos);
  EXPECT_NE(complaint("check,0123,0,0,0,0,0,0\nfit,0123,0,0,0,0,0,0").find("line 3"),
            std::string::npos);
  EXPECT_THROW(readTrials("/nowhere/trials.csv", 4), std::runtime_error);
  EXPECT_THROW(writePlan({}, "/nowhere/plan.csv"), std::runtime_error);
}

TEST(Calibration, TellsWhatWasFoundAndHowWellItPredicts) {
  Physics body;
  body.servo_gain_scale = 0.8;
  std::vector<Trial> trials = trialsOf(body, 6);
  trials[4].is_check = trials[5].is_check = true;
  FitOptions options;
  options.rounds = 5;
  Calibration found = calibrate(imaginationOf(), Physics(), trials, options);
  EXPECT_LT(medianOf(found.missesOf(found.after, true)).position_m,
            0.5 * medianOf(found.missesOf(found.before, true)).position_m);
  EXPECT_EQ(reportOf(found, "it").find("true |"), std::string::npos);
  found.truth = parametersOf(body, Physics());
  const std::string report = reportOf(found, "it");
  for (const char* words : {"# Calibration of it", "| servo_gain_scale | 0.", "| 0.800 |",
                            "| 4 behaviours fitted |", "| 2 behaviours not fitted |"}) {
    EXPECT_NE(report.find(words), std::string::npos) << words << "\n" << report;
  }
  EXPECT_NE(pictureData(found, "it").find("\"check\": true"), std::string::npos);
}

}  // namespace
}  // namespace hexapod
