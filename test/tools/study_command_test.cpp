#include "tools/study_command.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace hexapod {
namespace {

TEST(StudyCommand, IsThePapersStudyUnlessTold) {
  const StudyCommand command = studyCommandFrom({});
  EXPECT_EQ(command.runs, 40);
  EXPECT_EQ(command.evaluations, 1000000);
  EXPECT_EQ(command.study.targets, 100);
  EXPECT_EQ(command.study.behavior.end_pose, EndPose::kAfterGait);
  EXPECT_FALSE(command.study.evolution.offer_twins);
  EXPECT_EQ(plansOf(command).size(), 120u);
}

TEST(StudyCommand, QuickIsSmallerUnlessTold) {
  EXPECT_EQ(studyCommandFrom({"quick:=true"}).evaluations, 100000);
  const StudyCommand command = studyCommandFrom({"--quick", "--runs", "7"});
  EXPECT_EQ(command.runs, 7);
  EXPECT_EQ(command.evaluations, 100000);
}

TEST(StudyCommand, DoesAllAlgorithmsOfASeedBeforeTheNext) {
  const auto plans = plansOf(
      studyCommandFrom({"--runs", "2", "--first_seed", "5", "--algorithms", "targets,map_elites"}));
  ASSERT_EQ(plans.size(), 4u);
  EXPECT_EQ(plans[0].name(), "targets_5_1000000");
  EXPECT_EQ(plans[1].name(), "map_elites_5_1000000");
  EXPECT_EQ(plans[2].name(), "targets_6_1000000");
}

TEST(StudyCommand, TakesTheStudysOptionsFromAPresetOfTheLearner) {
  EXPECT_TRUE(studyCommandFrom({"--preset", "learn"}).study.evolution.offer_twins);
  EXPECT_FALSE(studyCommandFrom({"--preset", "learn", "--offer_twins", "false"})
                   .study.evolution.offer_twins);
}

TEST(StudyCommand, RefusesAnOptionInAFileThatNeitherStudyNorLearnerHas) {
  const std::string file = testing::TempDir() + "hexapod_study_options.yaml";
  std::ofstream(file) << "mutation_rate: 0.2\ncheckpoint_period_s: 1.0\n";
  EXPECT_EQ(studyCommandFrom({"--config", file}).study.evolution.mutation_rate, 0.2);
  std::ofstream(file) << "mutatoin_rate: 0.2\n";
  try {
    studyCommandFrom({"--config", file});
    ADD_FAILURE() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'mutation_rate'"), std::string::npos)
        << error.what();
  }
  std::filesystem::remove(file);
}

TEST(StudyCommand, NamesTheAlgorithmsThereAre) {
  for (const std::string wrong : {"annealing", "targets,targets", "targets,,map_elites"}) {
    try {
      studyCommandFrom({"--algorithms", wrong});
      FAIL() << wrong;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("br_evolution,targets,map_elites"),
                std::string::npos);
    }
  }
}

}  // namespace
}  // namespace hexapod
