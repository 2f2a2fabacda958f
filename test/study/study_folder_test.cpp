#include "study/study_folder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <stdexcept>

#include "study/run_files.h"

namespace hexapod {
namespace {

namespace fs = std::filesystem;

class StudyFolderTest : public testing::Test {
 protected:
  void TearDown() override { fs::remove_all(path_); }

  static void writeRun(const std::string& run_folder) {
    writeRunFacts(run_folder + "/run.csv", {{"option.targets", "100"}, {"machine", "a, \"b\""}});
  }

  fs::path path_ = fs::path(testing::TempDir()) / ("study_" + std::to_string(::getpid()));
  StudyFolder folder_{path_.string()};
  RunPlan plan_{"map_elites", 3, 1000};
};

TEST_F(StudyFolderTest, KeepsARunUnderItsName) {
  EXPECT_FALSE(folder_.isDone(plan_));
  EXPECT_EQ(folder_.perform(plan_, writeRun), StudyFolder::Claim::kPerformed);
  EXPECT_TRUE(folder_.isDone(plan_));
  EXPECT_TRUE(fs::exists(path_ / "map_elites_3_1000" / "run.csv"));
}

TEST_F(StudyFolderTest, DoesNoRunTwice) {
  folder_.perform(plan_, writeRun);
  const auto complain = [](const std::string&) { FAIL() << "was done already"; };
  EXPECT_EQ(folder_.perform(plan_, complain), StudyFolder::Claim::kTaken);
}

TEST_F(StudyFolderTest, ALongerRunWentThroughAShorterOne) {
  folder_.perform(plan_, writeRun);
  EXPECT_TRUE(folder_.isDone({"map_elites", 3, 500}));
  EXPECT_FALSE(folder_.isDone({"map_elites", 3, 2000}));
  EXPECT_FALSE(folder_.isDone({"map_elites", 4, 1000}));
  EXPECT_FALSE(folder_.isDone({"targets", 3, 1000}));
}

TEST_F(StudyFolderTest, LeavesARunToWhoIsAtIt) {
  folder_.perform(plan_, [&](const std::string& run_folder) {
    StudyFolder other(path_.string());
    EXPECT_EQ(other.perform(plan_, [](const std::string&) { FAIL(); }), StudyFolder::Claim::kTaken);
    writeRun(run_folder);
  });
  EXPECT_TRUE(folder_.isDone(plan_));
}

TEST_F(StudyFolderTest, BeginsAnInterruptedRunAnew) {
  fs::create_directories(path_ / ".unfinished_map_elites_3_1000");
  std::ofstream(path_ / ".unfinished_map_elites_3_1000" / "run.csv") << "half";
  EXPECT_FALSE(folder_.isDone(plan_));
  folder_.perform(plan_, [](const std::string& run_folder) {
    EXPECT_TRUE(fs::is_empty(run_folder));
    writeRun(run_folder);
  });
  EXPECT_TRUE(folder_.isDone(plan_));
}

TEST_F(StudyFolderTest, NotesAFailureUntilTheRunSucceeds) {
  const auto fail = [](const std::string&) { throw std::runtime_error("the disk is full"); };
  EXPECT_THROW(folder_.perform(plan_, fail), std::runtime_error);
  EXPECT_FALSE(folder_.isDone(plan_));
  std::string reason;
  std::getline(std::ifstream(path_ / "map_elites_3_1000.failed") >> std::ws, reason);
  EXPECT_EQ(reason, "the disk is full");
  folder_.perform(plan_, writeRun);
  EXPECT_FALSE(fs::exists(path_ / "map_elites_3_1000.failed"));
}

TEST_F(StudyFolderTest, RefusesOptionsOtherThanThoseOfItsRuns) {
  folder_.requireSameOptions({{"option.targets", "50"}});  // there is none yet
  folder_.perform(plan_, writeRun);
  folder_.requireSameOptions({{"option.targets", "100"}});
  try {
    folder_.requireSameOptions({{"option.targets", "50"}});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("option.targets: 100 there, 50 now"),
              std::string::npos);
  }
}

TEST_F(StudyFolderTest, ReadsFactsBackAsTheyWere) {
  folder_.perform(plan_, writeRun);
  const RunFacts facts = readRunFacts((path_ / "map_elites_3_1000" / "run.csv").string());
  EXPECT_EQ(facts.at("machine"), "a, \"b\"");
}

TEST_F(StudyFolderTest, CannotBeWhereAFileIs) {
  folder_.perform(plan_, writeRun);
  const fs::path file = path_ / "map_elites_3_1000" / "run.csv";
  EXPECT_THROW(StudyFolder(file.string()), std::runtime_error);
}

}  // namespace
}  // namespace hexapod
