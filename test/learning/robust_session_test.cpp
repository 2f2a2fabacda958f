#include <gtest/gtest.h>

#include "learning/learning_report.h"
#include "learning_fixture.h"

namespace hexapod {
namespace {

class RobustSession : public LearningFixture {
 protected:
  /// Everything beyond the paper at once.
  LearnOptions robustRun(const std::string& name) const {
    LearnOptions options = smallRun(name);
    options.evaluations = 60;
    options.behavior.gait_duration_s = 0.6;
    options.evolution.novelty_threshold_m = 0.005;  // so short gaits do not lead far
    options.evolution.offer_twins = true;
    options.evolution.archive_parents = 0.5;
    options.evolution.novelty_decay = 0.5;
    options.evolution.novelty_decay_from = 10;
    options.evolution.novelty_threshold_min_m = 0.001;
    options.robustness.perturbed_physics = 2;
    options.robustness.start_states = 1;
    return options;
  }
};

TEST_F(RobustSession, GoesOnAsIfItHadNeverStopped) {
  LearnOptions options = robustRun("resumed.db");
  for (const std::int64_t evaluations : {10, 30, 60}) {
    options.evaluations = evaluations;
    options.resume = true;
    EXPECT_TRUE(learn(options));
  }
  const Repertoire resumed = loadRepertoire(options.repertoire_file);
  const Repertoire whole = undisturbed(robustRun(""));
  EXPECT_FALSE(whole.entries.empty());
  EXPECT_EQ(digestOf(resumed.entries), digestOf(whole.entries));
}

TEST_F(RobustSession, IsTheSameOnOneAndOnFourThreads) {
  LearnOptions options = robustRun("threads.db");
  options.threads = 4;
  EXPECT_TRUE(learn(options));
  options.threads = 1;
  expectSameRun(undisturbed(options), loadRepertoire(options.repertoire_file));
}

TEST_F(RobustSession, OffersTwinsAndCountsWhatItSimulates) {
  LearnOptions options = robustRun("");
  options.behavior.gait_duration_s = 3.0;
  const Repertoire repertoire = undisturbed(options);
  std::int64_t twins = 0;
  for (const Entry& entry : repertoire.entries) twins += entry.id % 4 != 1;
  EXPECT_GT(twins, 0);
  const std::int64_t simulations = std::stoll(repertoire.facts.at("simulations"));
  EXPECT_GT(simulations, 60);
  EXPECT_LE(simulations, 60 * 4);
}

TEST_F(RobustSession, KeepsWhatIsLeftOfItInOtherWorlds) {
  LearnOptions options = robustRun("");
  options.behavior.gait_duration_s = 3.0;
  options.resimulate = true;
  const Repertoire repertoire = undisturbed(options);
  const auto fact = [&](const std::string& name) {
    return std::stod(repertoire.facts.at("resimulated." + name));
  };
  EXPECT_EQ(fact("nominal.failed"), 0.0);
  EXPECT_GT(fact("5 ms step.median_shift_m"), 0.0);
  EXPECT_GT(fact("torque -20 %.sparseness_m"), 0.0);
  EXPECT_GE(fact("mu 0.7.median_orientation_error_rad"), 0.0);
  ASSERT_TRUE(repertoire.history.back().held_out.has_value());
  EXPECT_GT(repertoire.history.back().held_out->median_shift_m, 0.0);
}

TEST_F(RobustSession, KeepsNowAndThenWhatWouldBeLeftOfItInOtherWorlds) {
  LearnOptions options = smallRun("");
  options.evaluations = 4000;
  options.evolution.population_size = 100;
  options.behavior.gait_duration_s = 0.3;
  options.evolution.novelty_threshold_m = 0.005;
  options.resimulate = true;
  std::vector<std::int64_t> tried;
  for (const HistoryRow& row : undisturbed(options).history) {
    if (row.held_out) tried.push_back(row.evaluations);
  }
  EXPECT_EQ(tried, (std::vector<std::int64_t>{1000, 3000, 4000}));
}

TEST_F(RobustSession, WithoutAnyEntryEndsTellingWhatBecameOfTheCandidates) {
  LearnOptions options = robustRun("nothing.db");
  options.evolution.novelty_threshold_m = 5.0;
  options.evolution.novelty_decay = 0.0;
  const std::string complaint = complaintOf([&] { learn(options); });
  EXPECT_TRUE(mentions(complaint, "Nothing was learned: of 60 candidates ")) << complaint;
  EXPECT_TRUE(mentions(complaint, "none to a new place")) << complaint;
}

TEST(NothingLearned, TellsThoseApartThatFailedUnderOtherConditionsOnly) {
  EvolutionCounters counters;
  counters.evaluations = 60;
  counters.fell = 40;
  counters.self_collided = 15;
  counters.diverged = 5;
  counters.failed_later = 12;
  EXPECT_EQ(nothingLearned(counters, 0),
            "Nothing was learned: of 60 candidates 40 fell, 15 touched a leg with another, 5 blew "
            "up (12 of these only under perturbed physics or after other behaviours) and 0 walked. "
            "import_robot tells how a robot stands and walks.");
  counters.fell = 33;
  EXPECT_TRUE(mentions(nothingLearned(counters, 0), "and 7 walked, none to a new place"));
  EXPECT_TRUE(mentions(nothingLearned(counters, 7), "7 walked; ODE confirms none of the 7"));
}

TEST_F(RobustSession, LearnsInLengthsThatSuitTheRobot) {
  const LearnOptions given = robustRun("");
  const LearnOptions own = suitedTo(robot_, given);
  EXPECT_EQ(own.length_scale, 1.0);
  EXPECT_EQ(own.evolution.novelty_threshold_m, given.evolution.novelty_threshold_m);
  RobotDescription large = robot_;
  for (Leg& leg : large.legs) {
    for (Segment& segment : leg.segments) {
      segment.joint.parent_from_joint.translation() *= 2.0;
      for (Shape& shape : segment.body.shapes) {
        shape.body_from_shape.translation() *= 2.0;
        shape.length_m *= 2.0;
        shape.radius_m *= 2.0;
      }
    }
  }
  const LearnOptions twice = suitedTo(large, given);
  EXPECT_DOUBLE_EQ(twice.evolution.novelty_threshold_m, 0.01);
  EXPECT_DOUBLE_EQ(twice.robustness.spread_weight_rad_per_m, 2.0);
  LearnOptions fixed = given;
  fixed.length_scale = 3.0;
  EXPECT_DOUBLE_EQ(suitedTo(large, fixed).evolution.novelty_threshold_m, 0.015);
}

TEST_F(RobustSession, OfTheSameRobotIsAnotherRunThanANominalOne) {
  EXPECT_NE(undisturbed(robustRun("")).run_id, undisturbed(smallRun("")).run_id);
}

}  // namespace
}  // namespace hexapod
