// Every algorithm as a learner, with all that the default preset has: twins, three looks.
#include "evolution/algorithms.h"

#include <algorithm>
#include <cmath>

#include "learning_fixture.h"

namespace hexapod {
namespace {

class EveryLearner : public LearningFixture, public testing::WithParamInterface<std::string> {
 protected:
  void SetUp() override {
    LearningFixture::SetUp();
    folder_ = folder_.parent_path() / ("hexapod_learner_" + GetParam());
    std::filesystem::remove_all(folder_);
  }

  LearnOptions run(const std::string& name) const {
    LearnOptions options = smallRun(name);
    options.algorithm = GetParam();
    options.map_elites.cvt_cells = 200;
    options.evolution.offer_twins = true;
    options.robustness.perturbed_physics = 1;
    options.robustness.start_states = 1;
    options.robustness.screening_runs = 1;
    return options;
  }
};

TEST_P(EveryLearner, DependsOnItsSeedAndNotOnItsThreads) {
  LearnOptions one = run("one.db");
  one.threads = 1;
  LearnOptions three = run("three.db");
  three.threads = 3;
  LearnOptions other = run("other.db");
  other.seed = 2;
  ASSERT_TRUE(learn(one) && learn(three) && learn(other));
  const Repertoire first = loadRepertoire(one.repertoire_file);
  expectSameRun(first, loadRepertoire(three.repertoire_file));
  EXPECT_NE(digestOf(first.entries), digestOf(loadRepertoire(other.repertoire_file).entries));
  EXPECT_EQ(first.options.at("algorithm"), GetParam());
  EXPECT_GT(first.entries.size(), 5u);
}

TEST_P(EveryLearner, EndsAsIfItHadNotBeenKilledAfterEveryGeneration) {
  const LearnOptions options = run("killed.db");
  expectSameRun(killedAgainAndAgain(options), undisturbed(options));
}

INSTANTIATE_TEST_SUITE_P(Algorithms, EveryLearner, testing::ValuesIn(algorithmNames()));

/// Runs in which ends of one place and another heading are new, and the steadier ones win.
class PoseLearner : public LearningFixture {
 protected:
  LearnOptions run(const std::string& name) const {
    LearnOptions options = smallRun(name);
    options.evaluations = 300;
    options.checkpoint_period_s = 100.0;
    options.evolution.heading_m_per_rad = 0.2;
    options.evolution.offer_twins = true;
    options.robustness.perturbed_physics = 1;
    options.robustness.start_states = 1;
    options.robustness.screening_runs = 1;
    options.robustness.quality = "steadiness";
    return options;
  }
};

TEST_F(PoseLearner, LearnsSideStepsAndTurnsOnTheSpot) {
  const Repertoire repertoire = undisturbed(run(""));
  const auto count = [&](auto is) {
    return std::count_if(repertoire.entries.begin(), repertoire.entries.end(), is);
  };
  EXPECT_GT(count([](const Entry& entry) {
              return std::hypot(entry.end_pose.x_m, entry.end_pose.y_m) < 0.05 &&
                     std::abs(entry.end_pose.yaw_rad) > 0.3;
            }),
            0);
  EXPECT_GT(count([](const Entry& entry) {
              return std::abs(entry.end_pose.y_m) > 0.05 &&
                     std::abs(entry.end_pose.y_m) > 2.0 * std::abs(entry.end_pose.x_m) &&
                     std::abs(entry.end_pose.yaw_rad) < 0.2;
            }),
            0);
  EXPECT_EQ(repertoire.options.at("quality"), "steadiness");
}

TEST_F(PoseLearner, EndsAsIfItHadNotBeenKilledOnAnyNumberOfThreads) {
  LearnOptions options = run("a.db");
  options.evaluations = 55;
  options.checkpoint_period_s = 0.0;
  options.threads = 1;
  const Repertoire whole = undisturbed(options);
  options.threads = 3;
  expectSameRun(killedAgainAndAgain(options), whole);
}

TEST_F(PoseLearner, IsAnotherRunThanOneOfPositions) {
  LearnOptions options = run("a.db");
  options.evaluations = 55;
  ASSERT_TRUE(learn(options));
  options.resume = true;
  options.evolution.heading_m_per_rad = 0.0;
  const std::string sentence = complaintOf([&] { learn(options); });
  EXPECT_TRUE(mentions(sentence, "heading_m_per_rad: 0.2 in the file, 0 now")) << sentence;
}

TEST_F(LearningFixture, AnotherAlgorithmIsAnotherRun) {
  LearnOptions options = smallRun("a.db");
  ASSERT_TRUE(learn(options));
  options.resume = true;
  options.algorithm = "map_elites";
  const std::string sentence = complaintOf([&] { learn(options); });
  EXPECT_TRUE(mentions(sentence, "algorithm: br_evolution in the file, map_elites now"))
      << sentence;
}

}  // namespace
}  // namespace hexapod
