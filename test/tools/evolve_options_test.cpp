#include "tools/evolve_options.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace hexapod {
namespace {

using Words = std::vector<std::string>;

std::string complaintOf(const Words& words) {
  try {
    evolveOptionsFrom(words);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

bool mentions(const std::string& sentence, const std::string& words) {
  return sentence.find(words) != std::string::npos;
}

TEST(EvolveOptions, ReadsEveryKindOfValue) {
  const EvolveOptions options =
      evolveOptionsFrom({"--file", "a.db", "--seed=7", "--novelty_threshold_m", "0.05", "--resume",
                         "--limit-velocity", "false", "--engine", "ode", "--csv", "12"});
  EXPECT_EQ(options.learn.repertoire_file, "a.db");
  EXPECT_EQ(options.learn.seed, 7);
  EXPECT_EQ(options.learn.evolution.novelty_threshold_m, 0.05);
  EXPECT_TRUE(options.learn.resume);
  EXPECT_FALSE(options.learn.behavior.limit_velocity);
  EXPECT_EQ(options.learn.engine, "ode");
  EXPECT_EQ(options.csv, "12");
}

TEST(EvolveOptions, DescribesTheShippedRobotUnlessTold) {
  const EvolveOptions shipped = evolveOptionsFrom({"--file", "a.db"});
  EXPECT_TRUE(std::filesystem::exists(shipped.urdf)) << shipped.urdf;
  EXPECT_TRUE(std::filesystem::exists(shipped.robot_config)) << shipped.robot_config;
  EXPECT_EQ(evolveOptionsFrom({"--file", "a.db", "--urdf", "b.urdf"}).urdf, "b.urdf");
}

TEST(EvolveOptions, AFileComesOnTopOfThePresetAndTheCommandLineOnTopOfBoth) {
  const std::string file = testing::TempDir() + "hexapod_evolve_options.yaml";
  std::ofstream(file) << "seed: 5\nneighbours: 9\npublish_period_s: 3.0\n";
  const EvolveOptions options =
      evolveOptionsFrom({"--file", "a.db", "--config", file, "--seed", "6"});
  EXPECT_EQ(options.learn.seed, 6);
  EXPECT_EQ(options.learn.evolution.neighbours, 9);
  std::filesystem::remove(file);
}

TEST(EvolveOptions, LimitsARunByTimeAlone) {
  const EvolveOptions by_time = evolveOptionsFrom({"--file", "a.db", "--seconds", "90"});
  EXPECT_EQ(by_time.learn.time_budget_s, 90.0);
  EXPECT_EQ(withBudget(by_time.learn).evaluations, 1000000000);
  const EvolveOptions by_both =
      evolveOptionsFrom({"--file", "a.db", "--seconds", "90", "--evaluations", "500"});
  EXPECT_EQ(by_both.learn.evaluations, 500);
}

TEST(EvolveOptions, TakesABudgetOfTimeFromAFileForOne) {
  const std::string file = testing::TempDir() + "hexapod_evolve_time.yaml";
  std::ofstream(file) << "time_budget_s: 60.0\n";
  const EvolveOptions by_file = evolveOptionsFrom({"--file", "a.db", "--config", file});
  EXPECT_EQ(withBudget(by_file.learn).evaluations, 1000000000);
  std::filesystem::remove(file);
}

TEST(EvolveOptions, RefusesToWriteTheEntriesOverTheRepertoire) {
  for (const char* csv : {"a.db", "./a.db", "b/../a.db", "a.db.lock", "a.db-journal"}) {
    const std::string sentence = complaintOf({"--file", "a.db", "--csv", csv});
    EXPECT_TRUE(mentions(sentence, "'csv' and 'file' are the same file")) << csv << sentence;
  }
  EXPECT_EQ(evolveOptionsFrom({"--file", "a.db", "--csv", "a.csv"}).csv, "a.csv");
}

TEST(EvolveOptions, SuggestsTheNearestName) {
  const std::string sentence = complaintOf({"--file", "a.db", "--novelty_treshold_m", "0.05"});
  EXPECT_TRUE(mentions(sentence, "did you mean 'novelty_threshold_m'")) << sentence;
}

TEST(EvolveOptions, SuggestsTheNearestShortName) {
  const std::string sentence = complaintOf({"--fiel", "a.db"});
  EXPECT_TRUE(mentions(sentence, "'fiel' is not a known option; did you mean 'file'")) << sentence;
}

TEST(EvolveOptions, TellsAllThatIsWrongAtOnce) {
  const std::string sentence = complaintOf({"--sed", "1", "--threads", "-3", "--engine", "bullet"});
  for (const char* part : {"'sed'", "'threads'", "0 .. 1024", "'engine'", "reduced or ode"}) {
    EXPECT_TRUE(mentions(sentence, part)) << part << " is not in: " << sentence;
  }
}

TEST(EvolveOptions, RefusesWhatIsNoOption) {
  EXPECT_TRUE(mentions(complaintOf({"seed"}), "--seed 3"));
  EXPECT_TRUE(mentions(complaintOf({"--file", "a.db", "--seed"}), "no value"));
  EXPECT_TRUE(mentions(complaintOf({"--seed", "1", "--seed", "2"}), "twice"));
  EXPECT_TRUE(mentions(complaintOf({"--"}), "no option"));
  EXPECT_TRUE(mentions(complaintOf({"--file", "a.db", "--resume", "yes"}), "'yes'"));
  EXPECT_TRUE(mentions(complaintOf({}), "--file"));
}

TEST(EvolveOptions, HelpIsGivenWhateverElseIsMissing) {
  EXPECT_TRUE(evolveOptionsFrom({"--help"}).help);
  EXPECT_TRUE(evolveOptionsFrom({"-h"}).help);
  EXPECT_TRUE(mentions(evolveHelp(EvolveOptions()), "--population_size"));
}

}  // namespace
}  // namespace hexapod
