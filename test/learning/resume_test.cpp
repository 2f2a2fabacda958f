#include "learning/resume.h"

#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>

#include "learning_fixture.h"
#include "repertoire/repertoire_writer.h"
#include "repertoire/sqlite.h"

namespace hexapod {
namespace {

class ResumeTest : public LearningFixture {
 protected:
  LearnOptions resumed(LearnOptions options) const {
    options.resume = true;
    return options;
  }

  std::string remark(const LearnOptions& options) {
    return LearningSession(robot_, options, [this] { return now(); }).startRemark();
  }
};

std::string contentOf(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST_F(ResumeTest, EndsAsIfItHadNotBeenKilledAfterEveryGeneration) {
  const LearnOptions options = smallRun("a.db");
  expectSameRun(killedAgainAndAgain(options), undisturbed(options));
}

TEST_F(ResumeTest, RepeatsWhatWasLostSinceTheLastCheckpoint) {
  LearnOptions options = smallRun("a.db");
  options.checkpoint_period_s = 1000.0;
  {
    LearningSession session(robot_, options, [this] { return now(); });
    LearningSession::Hooks hooks;
    hooks.progress = [&](const LearningSession& running) {
      const std::int64_t generation = running.status().counters.generations;
      if (generation == 1) {
        EXPECT_EQ(session.saveNow(), "");
      }
      if (generation == 4) throw Killed();
    };
    EXPECT_THROW(session.run(hooks), Killed);
  }
  EXPECT_EQ(loadRepertoire(options.repertoire_file).generation, 1);
  ASSERT_TRUE(learn(resumed(options)));
  expectSameRun(loadRepertoire(options.repertoire_file), undisturbed(options));
}

TEST_F(ResumeTest, ValidatesAnewWhatWasKilledWhileValidating) {
  const LearnOptions options = smallRun("a.db");
  killWhen(options, [](const LearningStatus& status) {
    return status.phase == LearningPhase::kValidating && status.checked == 3;
  });
  EXPECT_EQ(loadRepertoire(options.repertoire_file).evaluations, 55);
  ASSERT_TRUE(learn(resumed(options)));
  expectSameRun(loadRepertoire(options.repertoire_file), undisturbed(options));
}

TEST_F(ResumeTest, VerifiesAnewWhatWasKilledWhileVerifying) {
  LearnOptions options = smallRun("a.db");
  options.verify_with_ode = true;
  options.behavior.gait_duration_s = 0.3;
  options.evolution.novelty_threshold_m = 0.01;
  killWhen(options, [](const LearningStatus& status) {
    return status.phase == LearningPhase::kVerifying && status.checked == 3;
  });
  EXPECT_EQ(loadRepertoire(options.repertoire_file).evaluations, 55);
  ASSERT_TRUE(learn(resumed(options)));
  const Repertoire repertoire = loadRepertoire(options.repertoire_file);
  expectSameRun(repertoire, undisturbed(options));
  EXPECT_EQ(repertoire.facts.count("verified_entries"), 1U);
}

TEST_F(ResumeTest, GoesOnWithARunThatWasStopped) {
  const LearnOptions options = smallRun("a.db");
  {
    LearningSession session(robot_, options, [this] { return now(); });
    LearningSession::Hooks hooks;
    hooks.progress = [&](const LearningSession& running) {
      if (running.status().counters.generations == 3) session.requestStop();
    };
    EXPECT_FALSE(session.run(hooks));
  }
  EXPECT_TRUE(mentions(remark(resumed(options)), "30 evaluations"));
  ASSERT_TRUE(learn(resumed(options)));
  expectSameRun(loadRepertoire(options.repertoire_file), undisturbed(options));
}

TEST_F(ResumeTest, BeginsWhenThereIsNothingToGoOnWithAndSaysSo) {
  const LearnOptions options = resumed(smallRun("a.db"));
  EXPECT_TRUE(mentions(remark(options), "no run in"));
  ASSERT_TRUE(learn(options));
  expectSameRun(loadRepertoire(options.repertoire_file), undisturbed(options));
}

TEST_F(ResumeTest, LeavesAFinishedRunAsItIs) {
  const LearnOptions options = smallRun("a.db");
  ASSERT_TRUE(learn(options));
  const std::string before = contentOf(options.repertoire_file);
  const std::string digest = digestOf(loadRepertoire(options.repertoire_file).entries);
  EXPECT_TRUE(mentions(remark(resumed(options)), "finished"));
  LearningSession session(robot_, resumed(options), [this] { return now(); });
  ASSERT_TRUE(session.run({}));
  EXPECT_EQ(session.status().phase, LearningPhase::kDone);
  EXPECT_EQ(digestOf(session.repertoire().entries), digest);
  EXPECT_EQ(contentOf(options.repertoire_file), before);
}

TEST_F(ResumeTest, ChecksAFinishedRunAnewWithOtherTrialsAsIfItHadHadThemFromTheStart) {
  LearnOptions options = smallRun("a.db");
  ASSERT_TRUE(learn(options));
  options.validation_trials = 3;
  ASSERT_TRUE(learn(resumed(options)));
  expectSameRun(loadRepertoire(options.repertoire_file), undisturbed(options));
}

TEST_F(ResumeTest, ChecksAFinishedRunAgainWhenTold) {
  LearnOptions options = smallRun("a.db");
  ASSERT_TRUE(learn(options));
  const Repertoire before = loadRepertoire(options.repertoire_file);
  options = resumed(options);
  options.check_again = true;
  std::int64_t validated = 0;
  LearningSession::Hooks hooks;
  hooks.progress = [&](const LearningSession& running) {
    if (running.status().phase == LearningPhase::kValidating) ++validated;
  };
  ASSERT_TRUE(learn(options, hooks));
  EXPECT_EQ(validated,
            options.validation_trials * static_cast<std::int64_t>(before.entries.size()));
  expectSameRun(loadRepertoire(options.repertoire_file), before);
}

TEST_F(ResumeTest, GivenMoreEvaluationsEndsAsIfItHadHadThemFromTheStart) {
  LearnOptions options = smallRun("a.db");
  options.evaluations = 30;
  ASSERT_TRUE(learn(options));
  options.evaluations = 60;
  ASSERT_TRUE(learn(resumed(options)));
  const Repertoire longer = loadRepertoire(options.repertoire_file);
  const Repertoire whole = undisturbed(options);
  EXPECT_EQ(digestOf(longer.entries), digestOf(whole.entries));
  EXPECT_EQ(longer.run_id, whole.run_id);
}

TEST_F(ResumeTest, GivenMoreTimeGoesOn) {
  LearnOptions options = smallRun("a.db");
  options.evaluations = 60;
  options.time_budget_s = 4.0;
  ASSERT_TRUE(learn(options));
  EXPECT_LT(loadRepertoire(options.repertoire_file).evaluations, 60);
  options.time_budget_s = 0.0;
  ASSERT_TRUE(learn(resumed(options)));
  const Repertoire longer = loadRepertoire(options.repertoire_file);
  EXPECT_EQ(digestOf(longer.entries), digestOf(undisturbed(options).entries));
}

TEST_F(ResumeTest, MayUseOtherThreadsAndOtherCheckpoints) {
  LearnOptions options = smallRun("a.db");
  killAfterGeneration(options, 2);
  options.threads = 3;
  options.checkpoint_period_s = 7.0;
  ASSERT_TRUE(learn(resumed(options)));
  expectSameRun(loadRepertoire(options.repertoire_file), undisturbed(options));
}

TEST_F(ResumeTest, RefusesAnotherRunListingEachDifference) {
  LearnOptions options = smallRun("a.db");
  killAfterGeneration(options, 2);
  const std::string before = contentOf(options.repertoire_file);
  options = resumed(options);
  options.seed = 7;
  options.evolution.novelty_threshold_m = 0.05;
  options.evaluations = 19;
  RobotDescription other = robot_;
  other.digest = "another-robot";
  const auto session = [&] { LearningSession(other, options, [this] { return now(); }); };
  EXPECT_THROW(session(), std::invalid_argument);
  const std::string sentence = complaintOf(session);
  for (const std::string part :
       {"a.db", "seed: 1 in the file, 7 now", "novelty_threshold_m: 0.1 in the file, 0.05 now",
        "evaluations: 20 done in the file, 19 now", "another-robot now"}) {
    EXPECT_TRUE(mentions(sentence, part)) << part << " is not in: " << sentence;
  }
  EXPECT_FALSE(mentions(sentence, "mutation_rate")) << sentence;
  EXPECT_EQ(contentOf(options.repertoire_file), before);
}

TEST_F(ResumeTest, RefusesAnotherFormatVersion) {
  const LearnOptions options = smallRun("a.db");
  killAfterGeneration(options, 2);
  SqliteDatabase(options.repertoire_file, SqliteDatabase::Mode::kWrite)
      .execute("PRAGMA user_version = 4");
  const std::string sentence = complaintOf([&] { learn(resumed(options)); });
  EXPECT_TRUE(mentions(sentence, "version 4") && mentions(sentence, "version 3")) << sentence;
}

TEST_F(ResumeTest, RefusesARunOfAnEarlierFormatAndSaysWhy) {
  const LearnOptions options = smallRun("a.db");
  killAfterGeneration(options, 2);
  StoredRepertoire stored = loadStoredRepertoire(options.repertoire_file);
  stored.learner_state.population.clear();
  stored.learner_state.archive.clear();
  saveRepertoire(options.repertoire_file, stored.repertoire, stored.learner_state);
  SqliteDatabase(options.repertoire_file, SqliteDatabase::Mode::kWrite)
      .execute("DROP TABLE population; DROP TABLE archive; PRAGMA user_version = 2");
  EXPECT_EQ(loadRepertoire(options.repertoire_file).entries.size(),
            stored.repertoire.entries.size());
  const std::string sentence = complaintOf([&] { learn(resumed(options)); });
  EXPECT_TRUE(mentions(sentence, "format version 2") && mentions(sentence, "Nothing was changed"))
      << sentence;
}

TEST_F(ResumeTest, RefusesARepertoireWithoutTheStateOfItsLearner) {
  const LearnOptions options = smallRun("a.db");
  killAfterGeneration(options, 2);
  saveRepertoire(options.repertoire_file, loadRepertoire(options.repertoire_file));
  const std::string sentence = complaintOf([&] { learn(resumed(options)); });
  EXPECT_TRUE(mentions(sentence, "a.db") && mentions(sentence, "learner state")) << sentence;
}

TEST_F(ResumeTest, RefusesToBothGoOnAndOverwrite) {
  LearnOptions options = resumed(smallRun("a.db"));
  options.overwrite = true;
  EXPECT_THROW(learn(options), std::invalid_argument);
}

TEST_F(ResumeTest, RefusesAStateThatDoesNotFitItsEntries) {
  const LearnOptions options = smallRun("a.db");
  killAfterGeneration(options, 2);
  const StoredRepertoire stored = loadStoredRepertoire(options.repertoire_file);
  const auto refused = [&](auto spoil) {
    LearnerState state = stored.learner_state;
    spoil(state);
    saveRepertoire(options.repertoire_file, stored.repertoire, state);
    return mentions(complaintOf([&] { learn(resumed(options)); }), "cannot be resumed");
  };
  EXPECT_TRUE(refused([](LearnerState& state) { state.archive.pop_back(); }));
  EXPECT_TRUE(refused([](LearnerState& state) { state.archive[0].id = 999999; }));
  EXPECT_TRUE(refused([](LearnerState& state) { state.dropped = {state.archive[0].id}; }));
  for (const std::string key : {"session.phase", "session.elapsed_s", "random"}) {
    EXPECT_TRUE(refused([&](LearnerState& state) { state.values.at(key) = "nonsense"; })) << key;
  }
}

}  // namespace
}  // namespace hexapod
