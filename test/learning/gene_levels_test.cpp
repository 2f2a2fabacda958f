#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "learning/worker.h"
#include "learning_fixture.h"
#include "queue_channel.h"
#include "repertoire/repertoire_writer.h"

namespace hexapod {
namespace {

/// Runs of gaits as good as continuous, their twins offered.
class GeneLevelsTest : public LearningFixture {
 protected:
  LearnOptions continuousRun(const std::string& name) const {
    LearnOptions options = smallRun(name);
    options.behavior.gene_levels = 253;
    options.evolution.offer_twins = true;
    options.evolution.novelty_threshold_m = 0.02;
    return options;
  }
};

TEST_F(GeneLevelsTest, AContinuousRunFindsGaitsThatTheFiveLevelsHaveNot) {
  const Repertoire repertoire = undisturbed(continuousRun(""));
  EXPECT_EQ(repertoire.geneLevels(), 253U);
  ASSERT_GT(repertoire.entries.size(), 4U);
  for (const Entry& entry : repertoire.entries) {
    EXPECT_TRUE(std::any_of(entry.genome.begin(), entry.genome.end(),
                            [](std::uint8_t level) { return level % 63 != 0; }));
    EXPECT_EQ(entry.genome, canonical(entry.genome, 253));
  }
}

TEST_F(GeneLevelsTest, ItsEntriesDoNotDependOnThreads) {
  LearnOptions options = continuousRun("");
  options.threads = 1;
  const Repertoire alone = undisturbed(options);
  options.threads = 3;
  expectSameRun(undisturbed(options), alone);
}

TEST_F(GeneLevelsTest, NorOnTheGenerationAfterWhichItWasKilled) {
  const LearnOptions options = continuousRun("a.db");
  expectSameRun(killedAgainAndAgain(options), undisturbed(options));
}

TEST_F(GeneLevelsTest, NorOnHelpingProcesses) {
  LearnOptions options = continuousRun("a.db");
  options.threads = 1;
  const std::atomic<bool> never{false};
  auto [here, there] = QueueChannel::makePair();
  std::thread worker([&, channel = there] { workFor(*channel, robot_, options, never); });
  {
    LearningSession session(robot_, options, [this] { return now(); }, {here});
    EXPECT_TRUE(session.run({}));
  }
  here->send("");
  worker.join();
  expectSameRun(loadRepertoire(options.repertoire_file), undisturbed(options));
}

TEST_F(GeneLevelsTest, ItIsNotGoneOnWithInOtherLevels) {
  LearnOptions options = continuousRun("a.db");
  ASSERT_TRUE(learn(options));
  options.resume = true;
  options.behavior.gene_levels = 5;
  const std::string sentence = complaintOf([&] { learn(options); });
  EXPECT_TRUE(mentions(sentence, "gene_levels: 253 in the file, 5 now")) << sentence;
}

TEST_F(GeneLevelsTest, ARunFromBeforeThereWasAChoiceGoesOnWithTheFive) {
  LearnOptions options = smallRun("a.db");
  options.evaluations = 50;
  ASSERT_TRUE(learn(options));
  StoredRepertoire stored = loadStoredRepertoire(options.repertoire_file);
  ASSERT_EQ(stored.repertoire.options.erase("gene_levels"), 1U);
  EXPECT_EQ(stored.repertoire.geneLevels(), 5U);
  saveRepertoire(options.repertoire_file, stored.repertoire, stored.learner_state);
  options.resume = true;
  options.evaluations = 75;
  ASSERT_TRUE(learn(options));
  EXPECT_EQ(digestOf(loadRepertoire(options.repertoire_file).entries),
            digestOf(undisturbed(options).entries));
}

TEST_F(GeneLevelsTest, LevelsThatMakeNoGaitAreRefused) {
  LearnOptions options = smallRun("a.db");
  options.behavior.gene_levels = 6;
  EXPECT_TRUE(mentions(complaintOf([&] { learn(options); }), "gene_levels is 6"));
}

}  // namespace
}  // namespace hexapod
