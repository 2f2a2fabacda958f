#include "learning/learning_session.h"

#include <sys/resource.h>

#include <csignal>
#include <map>
#include <set>
#include <stdexcept>
#include <thread>

#include "learning_fixture.h"

namespace hexapod {
namespace {

namespace fs = std::filesystem;

class LearningSessionTest : public LearningFixture {};

TEST_F(LearningSessionTest, StoresAValidatedRepertoireOfExactlyItsBudget) {
  const LearnOptions options = smallRun("a.db");
  ASSERT_TRUE(learn(options));
  const Repertoire repertoire = loadRepertoire(options.repertoire_file);
  EXPECT_EQ(repertoire.evaluations, 55);
  EXPECT_EQ(repertoire.robot_id, robot_.digest);
  EXPECT_EQ(repertoire.joint_names, robot_.jointNames());
  EXPECT_NEAR(repertoire.behavior_duration_s, 3.9, 1e-9);
  EXPECT_EQ(repertoire.options.at("population_size"), "10");
  ASSERT_FALSE(repertoire.history.empty());
  EXPECT_EQ(repertoire.history.back().evaluations, 55);
  ASSERT_FALSE(repertoire.entries.empty());
  for (const Entry& entry : repertoire.entries) {
    ASSERT_TRUE(entry.execution);
    EXPECT_EQ(entry.execution->trials, 2);
  }
}

TEST_F(LearningSessionTest, DependsOnItsSeedAndNotOnItsThreads) {
  LearnOptions one = smallRun("one.db");
  one.threads = 1;
  LearnOptions three = smallRun("three.db");
  three.threads = 3;
  LearnOptions other = smallRun("other.db");
  other.seed = 2;
  ASSERT_TRUE(learn(one) && learn(three) && learn(other));
  const Repertoire first = loadRepertoire(one.repertoire_file);
  expectSameRun(first, loadRepertoire(three.repertoire_file));
  EXPECT_NE(digestOf(first.entries), digestOf(loadRepertoire(other.repertoire_file).entries));
}

TEST_F(LearningSessionTest, StopsWithinTheGenerationAndKeepsWholeOnes) {
  const LearnOptions options = smallRun("stopped.db");
  LearningSession session(robot_, options, [this] { return now(); });
  LearningSession::Hooks hooks;
  hooks.progress = [&](const LearningSession& running) {
    if (running.status().counters.generations == 2) session.requestStop();
  };
  EXPECT_FALSE(session.run(hooks));
  EXPECT_EQ(loadRepertoire(options.repertoire_file).generation, 2);
}

TEST_F(LearningSessionTest, LeavesNothingBehindWhenStoppedBeforeItsFirstGeneration) {
  const LearnOptions options = smallRun("none.db");
  {
    LearningSession session(robot_, options, [this] { return now(); });
    session.requestStop();
    EXPECT_FALSE(session.run({}));
  }
  EXPECT_TRUE(learn(options));
}

TEST_F(LearningSessionTest, ReplacesARepertoireOnlyWhenTold) {
  LearnOptions options = smallRun("kept.db");
  options.evaluations = 10;
  ASSERT_TRUE(learn(options));
  const std::string before = digestOf(loadRepertoire(options.repertoire_file).entries);
  options.seed = 2;
  const std::string sentence = complaintOf([&] { learn(options); });
  EXPECT_TRUE(mentions(sentence, "kept.db") && mentions(sentence, "resume") &&
              mentions(sentence, "overwrite"))
      << sentence;
  EXPECT_EQ(digestOf(loadRepertoire(options.repertoire_file).entries), before);
  options.overwrite = true;
  ASSERT_TRUE(learn(options));
  EXPECT_NE(digestOf(loadRepertoire(options.repertoire_file).entries), before);
}

TEST_F(LearningSessionTest, AsksForAFile) {
  EXPECT_THROW(learn(LearnOptions()), std::invalid_argument);
}

TEST_F(LearningSessionTest, RefusesAFileThatAnotherSessionWritesNamingItsProcess) {
  const LearnOptions options = smallRun("a.db");
  const LearningSession first(robot_, options, [this] { return now(); });
  const std::string sentence = complaintOf([&] { learn(options); });
  EXPECT_TRUE(mentions(sentence, "a.db")) << sentence;
  EXPECT_TRUE(mentions(sentence, "process " + std::to_string(::getpid()))) << sentence;
}

TEST_F(LearningSessionTest, GoesOnWhenTheFileCannotBeWrittenAndTellsSo) {
  const LearnOptions options = smallRun("gone/a.db");
  LearningSession session(robot_, options, [this] { return now(); });
  int failures = 0;
  LearningSession::Hooks hooks;
  hooks.save_failed = [&](const std::string& problem) {
    EXPECT_NE(problem.find("gone"), std::string::npos) << problem;
    ++failures;
  };
  hooks.progress = [&](const LearningSession& running) {
    if (running.status().counters.generations == 1) {
      fs::remove_all(folder_ / "gone");
      fs::create_directories(folder_);
      // A link where the folder was: it cannot be created anew.
      fs::create_symlink("/nowhere", folder_ / "gone");
    }
  };
  EXPECT_TRUE(session.run(hooks));
  EXPECT_GT(failures, 0);
}

/// As long as it lives no file grows beyond a page: to a process that is a full disk.
class FullDisk {
 public:
  FullDisk() {
    std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    rlimit full = before_;
    full.rlim_cur = 4096;
    ::setrlimit(RLIMIT_FSIZE, &full);
  }
  ~FullDisk() { ::setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

TEST_F(LearningSessionTest, KeepsTheLastGoodStateOnAFullDiskAndSavesAgainWhenThereIsRoom) {
  const LearnOptions options = smallRun("a.db");
  std::unique_ptr<FullDisk> full;
  std::map<std::int64_t, std::int64_t> saved;  // generation in the file after each generation
  int failures = 0;
  LearningSession::Hooks hooks;
  hooks.save_failed = [&](const std::string&) { ++failures; };
  hooks.progress = [&](const LearningSession& running) {
    const LearningStatus status = running.status();
    if (status.phase != LearningPhase::kEvolving) return;
    const std::int64_t generation = status.counters.generations;
    full.reset();
    saved[generation] = loadRepertoire(options.repertoire_file).generation;
    if (generation == 2 || generation == 3) full = std::make_unique<FullDisk>();
  };
  EXPECT_TRUE(learn(options, hooks));
  EXPECT_EQ(failures, 2);
  EXPECT_EQ(saved,
            (std::map<std::int64_t, std::int64_t>{{1, 1}, {2, 2}, {3, 2}, {4, 2}, {5, 5}, {6, 6}}));
}

TEST_F(LearningSessionTest, SaysThatItsLastSaveFailedUntilOneSucceeds) {
  const LearnOptions options = smallRun("a.db");
  LearningSession session(robot_, options, [this] { return now(); });
  std::unique_ptr<FullDisk> full;
  LearningSession::Hooks hooks;
  hooks.progress = [&](const LearningSession& running) {
    if (running.status().counters.generations == 3) full = std::make_unique<FullDisk>();
  };
  EXPECT_TRUE(session.run(hooks));
  EXPECT_TRUE(mentions(session.saveProblem(), "a.db")) << session.saveProblem();
  EXPECT_EQ(session.saveNow(), session.saveProblem());
  EXPECT_EQ(loadRepertoire(options.repertoire_file).generation, 3);
  full.reset();
  EXPECT_EQ(session.saveNow(), "");
  EXPECT_EQ(session.saveProblem(), "");
  EXPECT_EQ(digestOf(loadRepertoire(options.repertoire_file).entries),
            digestOf(session.repertoire().entries));
}

TEST_F(LearningSessionTest, SavesInEveryPhaseWhenAnotherThreadAsksForIt) {
  LearnOptions options = smallRun("a.db");
  options.checkpoint_period_s = 1000.0;
  options.resimulate = true;
  options.behavior.gait_duration_s = 0.3;
  options.evolution.novelty_threshold_m = 0.01;
  LearningSession session(robot_, options, [this] { return now(); });
  EXPECT_TRUE(mentions(session.saveNow(), "Nothing has been learned yet"));
  std::set<std::string> saved_phases;
  LearningSession::Hooks hooks;
  hooks.progress = [&](const LearningSession& running) {
    const std::string phase = toString(running.status().phase);
    if (!saved_phases.insert(phase).second) return;
    std::thread([&] { EXPECT_EQ(session.saveNow(), ""); }).join();
    EXPECT_EQ(loadLearnerState(options.repertoire_file).values.at("session.phase"), phase);
  };
  EXPECT_TRUE(session.run(hooks));
  EXPECT_EQ(saved_phases,
            (std::set<std::string>{"evolving", "validating", "trying_worlds", "done"}));
}

TEST_F(LearningSessionTest, IsLimitedByTimeAloneWhenOnlyATimeIsGiven) {
  LearnOptions options;
  EXPECT_EQ(withBudget(options).evaluations, 20000);
  options.time_budget_s = 60.0;
  EXPECT_EQ(withBudget(options).evaluations, 1000000000);
  options.evaluations = 300;
  EXPECT_EQ(withBudget(options).evaluations, 300);
}

TEST_F(LearningSessionTest, SavesAboutEveryPeriod) {
  LearnOptions options = smallRun("a.db");
  options.evaluations = 80;
  options.checkpoint_period_s = 3.0;
  options.validation_trials = 0;
  double time_s = 0.0;
  std::vector<std::int64_t> saved;
  LearningSession::Hooks hooks;
  hooks.progress = [&](const LearningSession& running) {
    if (running.status().phase != LearningPhase::kEvolving) return;
    const bool exists = fs::file_size(options.repertoire_file) > 0;
    saved.push_back(exists ? loadRepertoire(options.repertoire_file).generation : 0);
    time_s += 1.0;
  };
  LearningSession(robot_, options, [&] { return time_s; }).run(hooks);
  EXPECT_EQ(saved, (std::vector<std::int64_t>{0, 0, 0, 4, 4, 4, 7, 7}));
}

TEST_F(LearningSessionTest, SavesMoreRarelyWhenSavingTakesLong) {
  LearnOptions options = smallRun("a.db");
  options.evaluations = 400;
  options.checkpoint_period_s = 0.001;
  options.validation_trials = 0;
  std::set<std::int64_t> saved;
  LearningSession::Hooks hooks;
  hooks.progress = [&](const LearningSession& running) {
    if (running.status().phase != LearningPhase::kEvolving) return;
    saved.insert(loadRepertoire(options.repertoire_file).generation);
  };
  ASSERT_TRUE(learn(options, hooks));
  // A save takes half a second of this clock: a hundredth of 50 s, in which it is read 100 times.
  const double most = 1.0 + time_s_ / 50.0;
  EXPECT_GE(saved.size(), 2U);
  EXPECT_LE(static_cast<double>(saved.size()), most);
}

TEST_F(LearningSessionTest, EndsWhenItsTimeIsUp) {
  LearnOptions options = smallRun("a.db");
  options.evaluations = 1000000;
  options.time_budget_s = 10.0;
  ASSERT_TRUE(learn(options));
  const Repertoire repertoire = loadRepertoire(options.repertoire_file);
  EXPECT_GT(repertoire.evaluations, 0);
  EXPECT_LT(repertoire.evaluations, 1000);
  EXPECT_GE(repertoire.history.back().elapsed_s, 10.0);
  EXPECT_LT(repertoire.history.back().elapsed_s, 15.0);
}

TEST(LearnOptions, NamesAreUnique) {
  LearnOptions options;
  std::map<std::string, int> names;
  for (const Option& option : declareOptions(options)) {
    EXPECT_EQ(++names[option.name], 1) << option.name;
  }
}

}  // namespace
}  // namespace hexapod
