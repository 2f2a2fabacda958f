#include "learning/warm_start.h"

#include <algorithm>
#include <atomic>

#include "learning/relearning.h"
#include "learning_fixture.h"
#include "simulation/body_text.h"
#include "simulation/rollout.h"

namespace hexapod {
namespace {

class WarmStartTest : public LearningFixture {
 protected:
  /// A repertoire of the robot as it is, under perturbations as by default.
  Repertoire learned(const LearnOptions& options) {
    EXPECT_TRUE(learn(options));
    return loadRepertoire(options.repertoire_file);
  }

  LearnOptions longerRun(const std::string& name) const {
    LearnOptions options = smallRun(name);
    options.evolution.population_size = 100;
    options.evaluations = 2000;
    options.validation_trials = 0;
    return options;
  }

  /// Of the entries of a repertoire, those that walk in a body.
  std::int64_t walking(const Repertoire& repertoire, const Physics& body) const {
    const auto world = makeWorld(Engine::kReduced, robot_, body);
    return std::count_if(
        repertoire.entries.begin(), repertoire.entries.end(), [&](const Entry& entry) {
          world->restart();
          const Behavior behavior(robot_, canonical(entry.genome), BehaviorOptions());
          return play(*world, behavior, BehaviorOptions().command_period_s).walked();
        });
  }
};

TEST_F(WarmStartTest, EvaluatesTheEntriesAnewInAnotherBody) {
  const Repertoire old = learned(longerRun("old.db"));
  LearnOptions options = longerRun("new.db");
  options.from = longerRun("old.db").repertoire_file;
  options.body = " left_middle :locked ";
  options.evaluations = static_cast<std::int64_t>(old.entries.size());
  const Repertoire fresh = learned(options);
  EXPECT_EQ(fresh.body(), "left_middle: locked");
  EXPECT_NE(fresh.run_id, old.run_id);
  const Physics body = bodyFromText(robot_, fresh.body());
  EXPECT_EQ(walking(fresh, body), static_cast<std::int64_t>(fresh.entries.size()));
  // Nothing was evaluated but the old entries.
  for (const Entry& entry : fresh.entries) {
    EXPECT_TRUE(std::any_of(old.entries.begin(), old.entries.end(),
                            [&](const Entry& one) { return one.genome == entry.genome; }));
  }
}

TEST_F(WarmStartTest, HasMoreThatWalksInThatBodyThanIsLeftOfTheOldOne) {
  const Repertoire old = learned(longerRun("old.db"));
  LearnOptions options = longerRun("new.db");
  options.from = longerRun("old.db").repertoire_file;
  options.body = "left_middle: locked";
  const Repertoire fresh = learned(options);
  const Physics body = bodyFromText(robot_, options.body);
  EXPECT_GT(walking(fresh, body), walking(old, body));
}

TEST_F(WarmStartTest, GoesOnAsIfItHadNotBeenStopped) {
  learned(smallRun("old.db"));
  LearnOptions options = smallRun("new.db");
  options.from = smallRun("old.db").repertoire_file;
  options.body = "friction: 0.8";
  LearnOptions resumed = options;
  resumed.resume = true;
  {
    LearningSession session(robot_, resumed, [this] { return now(); });
    LearningSession::Hooks hooks;
    hooks.progress = [&](const LearningSession&) { session.requestStop(); };
    EXPECT_FALSE(session.run(hooks));
  }
  // What it began with need not be told again; if it is, it must be the same.
  resumed.from = smallRun("new.db").repertoire_file;
  EXPECT_TRUE(mentions(complaintOf([&] { learn(resumed); }), "from: "));
  resumed.from.clear();
  ASSERT_TRUE(learn(resumed));
  expectSameRun(loadRepertoire(options.repertoire_file), undisturbed(options));
}

TEST_F(WarmStartTest, ASecondStartWithTheSameEntriesIsTheSameRun) {
  const Repertoire old = learned(smallRun("old.db"));
  const WarmStart start = warmStart(robot_, old, "it", 5);
  EXPECT_EQ(start.name, warmStart(robot_, smallRun("old.db").repertoire_file, 5).name);
  Repertoire less = old;
  less.entries.pop_back();
  EXPECT_NE(warmStart(robot_, less, "it", 5).name, start.name);
}

TEST_F(WarmStartTest, AContinuousRunBeginsWithEntriesOfTheFiveLevels) {
  const Repertoire old = learned(smallRun("old.db"));
  LearnOptions options = smallRun("new.db");
  options.from = smallRun("old.db").repertoire_file;
  options.behavior.gene_levels = 253;
  options.evaluations = static_cast<std::int64_t>(old.entries.size());
  const Repertoire begun = learned(options);
  EXPECT_FALSE(begun.entries.empty());
  for (const Entry& entry : begun.entries) {
    for (const auto level : entry.genome) EXPECT_EQ(level % 63, 0);
  }
  LearnOptions back = smallRun("back.db");
  back.from = options.repertoire_file;
  EXPECT_TRUE(mentions(complaintOf([&] { learn(back); }), "cannot be told in 5"));
}

TEST_F(WarmStartTest, SaysWhyARunCannotBeginSo) {
  Repertoire none;
  EXPECT_TRUE(
      mentions(complaintOf([&] { warmStart(robot_, none, "x.db", 5); }), "x.db: it has none"));
  Repertoire other;
  other.entries.resize(1);
  other.entries[0].genome = Genome(16, 0);
  EXPECT_TRUE(mentions(complaintOf([&] { warmStart(robot_, other, "x.db", 5); }), "16 genes"));
  LearnOptions options = smallRun("new.db");
  options.body = "tail: limp";
  EXPECT_TRUE(mentions(complaintOf([&] { learn(options); }), "'tail' is nothing of a body"));
  options.body.clear();
  options.from = "/nowhere/old.db";
  EXPECT_TRUE(mentions(complaintOf([&] { learn(options); }), "/nowhere/old.db"));
}

TEST_F(WarmStartTest, RelearnsInMemoryWhatAFileWouldHold) {
  const Repertoire old = learned(smallRun("old.db"));
  Physics body;
  body.legs = bodyFromText(robot_, "left_middle: locked").legs;
  RelearnOptions options;
  options.evaluations = 55;
  const std::atomic<bool> never{false}, at_once{true};
  const auto relearned = relearn(robot_, old, body, options, never);
  ASSERT_TRUE(relearned.has_value());
  LearnOptions in_file = smallRun("new.db");
  in_file.from = smallRun("old.db").repertoire_file;
  in_file.body = "left_middle: locked";
  EXPECT_EQ(digestOf(relearned->entries), digestOf(learned(in_file).entries));
  EXPECT_FALSE(relearn(robot_, old, body, options, at_once).has_value());
}

}  // namespace
}  // namespace hexapod
