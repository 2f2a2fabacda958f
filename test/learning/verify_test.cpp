#include "evaluation/verify.h"

#include "common/text.h"
#include "learning/checkpoint.h"
#include "learning_fixture.h"

namespace hexapod {
namespace {

class VerifyTest : public LearningFixture {};

BehaviorOptions brief() {
  BehaviorOptions options;
  options.gait_duration_s = 0.6;
  return options;
}

std::vector<Genome> someGenomes() {
  std::vector<Genome> genomes;
  for (const char* digits : {"404240424042424040424042", "202040400020000000433000",
                             "000000000000000000000000", "310420134210123412341234"}) {
    genomes.push_back(genomeFromString(digits));
  }
  return genomes;
}

TEST_F(VerifyTest, FindsTheEnginesInAgreementWithAnyNumberOfThreads) {
  const auto one = std::make_shared<WorldPool>(Engine::kReduced, robot_, Physics(), 1);
  const auto two = std::make_shared<WorldPool>(Engine::kReduced, robot_, Physics(), 2);
  const Verification expected = verifyInOde(one, brief(), someGenomes());
  const Verification verification = verifyInOde(two, brief(), someGenomes());
  EXPECT_EQ(expected.holds, std::vector<bool>(4, true));
  EXPECT_LT(expected.largest_difference_m, 1e-7);
  EXPECT_LT(expected.largest_difference_rad, 1e-6);
  EXPECT_EQ(verification.holds, expected.holds);
  EXPECT_EQ(verification.largest_difference_m, expected.largest_difference_m);
  EXPECT_EQ(verification.largest_difference_rad, expected.largest_difference_rad);
}

TEST(Verify, ToleratesATenthOfAMillimetreAndAMilliradianAndNoOtherVerdict) {
  const End end{Verdict::kWalked, {0.3, -0.1, 3.1415}};
  EXPECT_TRUE(agree(end, {Verdict::kWalked, {0.3 + 0.9e-4, -0.1, 3.1415}}));
  EXPECT_TRUE(agree(end, {Verdict::kWalked, {0.3, -0.1, -3.1410}}));
  EXPECT_FALSE(agree(end, {Verdict::kWalked, {0.3, -0.1 + 1.1e-4, 3.1415}}));
  EXPECT_FALSE(agree(end, {Verdict::kWalked, {0.3, -0.1, 3.1403}}));
  EXPECT_FALSE(agree(end, {Verdict::kFell, end.pose}));
  EXPECT_TRUE(agree({Verdict::kFell, {0.0, 0.0, 0.0}}, {Verdict::kFell, end.pose}));
}

TEST_F(VerifyTest, BeginsNothingOnceCancelled) {
  const auto pool = std::make_shared<WorldPool>(Engine::kReduced, robot_, Physics(), 1);
  const std::atomic<bool> cancelled{true};
  PlayHooks hooks;
  hooks.cancelled = &cancelled;
  hooks.progress = [](std::size_t, std::size_t) { FAIL(); };
  EXPECT_THROW(verifyInOde(pool, brief(), someGenomes(), hooks), EvaluationCancelled);
}

TEST_F(VerifyTest, IsRecordedInTheFile) {
  LearnOptions options = smallRun("a.db");
  options.verify_with_ode = true;
  options.behavior.gait_duration_s = 0.6;
  options.evolution.novelty_threshold_m = 0.02;
  std::int64_t seen = 0;
  LearningSession::Hooks hooks;
  hooks.progress = [&](const LearningSession& session) {
    const LearningStatus status = session.status();
    if (status.phase == LearningPhase::kVerifying) seen = std::max(seen, status.checked);
  };
  ASSERT_TRUE(learn(options, hooks));
  const Repertoire repertoire = loadRepertoire(options.repertoire_file);
  const std::string count = std::to_string(repertoire.entries.size());
  EXPECT_EQ(repertoire.facts.at("engine"), "reduced");
  EXPECT_EQ(repertoire.facts.at("verified_entries"), count);
  EXPECT_EQ(repertoire.facts.at("dropped_entries"), "0");
  EXPECT_LT(doubleFromText(repertoire.facts.at("largest_difference_m")).value(), 1e-7);
  EXPECT_LT(doubleFromText(repertoire.facts.at("largest_difference_rad")).value(), 1e-6);
  EXPECT_EQ(std::to_string(seen), count);
}

TEST_F(VerifyTest, ReplaysASampleOnlyWhereThatHolds) {
  LearnOptions options = smallRun("a.db");
  options.verify_with_ode = true;
  options.verification_sample = 2;
  options.behavior.gait_duration_s = 0.3;
  options.evolution.novelty_threshold_m = 0.02;
  ASSERT_TRUE(learn(options));
  const Repertoire repertoire = loadRepertoire(options.repertoire_file);
  EXPECT_GT(repertoire.entries.size(), 2u);
  EXPECT_EQ(repertoire.facts.at("verified_entries"), "2");
  EXPECT_EQ(repertoire.facts.at("dropped_entries"), "0");
}

TEST_F(VerifyTest, LeavesTheDroppedEntriesInTheCheckpoint) {
  const LearnOptions options = smallRun("a.db");
  ASSERT_TRUE(learn(options));
  StoredRepertoire stored = loadStoredRepertoire(options.repertoire_file);
  Checkpoint checkpoint = checkpointFrom(stored);
  ASSERT_GT(stored.repertoire.entries.size(), 2u);
  const Entry dropped = stored.repertoire.entries[1];
  checkpoint.dropped = {dropped.id};
  stored.learner_state = toLearnerState(checkpoint);
  stored.repertoire.entries.erase(stored.repertoire.entries.begin() + 1);
  const Checkpoint read = checkpointFrom(stored);
  EXPECT_EQ(read.dropped, checkpoint.dropped);
  EXPECT_EQ(digestOf(read.evolution.archive), digestOf(checkpoint.evolution.archive));
}

}  // namespace
}  // namespace hexapod
