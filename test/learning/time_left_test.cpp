#include "learning/time_left.h"

#include <algorithm>
#include <vector>

#include "learning_fixture.h"

namespace hexapod {
namespace {

class TimeLeftTest : public LearningFixture {
 protected:
  /// The status at each progress of a run.
  std::vector<LearningStatus> statusesOf(const LearnOptions& options) {
    std::vector<LearningStatus> statuses;
    LearningSession::Hooks hooks;
    hooks.progress = [&](const LearningSession& session) { statuses.push_back(session.status()); };
    EXPECT_TRUE(learn(options, hooks));
    return statuses;
  }
};

TEST_F(TimeLeftTest, OfEvolutionIsThatOfAllPhases) {
  const LearningStatus first = statusesOf(smallRun("a.db")).at(0);
  ASSERT_EQ(first.phase, LearningPhase::kEvolving);
  const auto evaluated = static_cast<double>(first.counters.evaluations);
  const double evolving_s = first.elapsed_s / evaluated * (55.0 - evaluated);
  const double simulation_s = first.elapsed_s / static_cast<double>(first.simulations);
  const double validating_s = simulation_s * 2.0 * static_cast<double>(first.entries);
  EXPECT_GT(validating_s, 0.0);
  EXPECT_NEAR(first.left_s, evolving_s + validating_s, 1e-9);
}

TEST_F(TimeLeftTest, OfTheLastCheckComesToNothing) {
  std::size_t checking = 0;
  for (const LearningStatus& status : statusesOf(smallRun("a.db"))) {
    if (status.phase != LearningPhase::kValidating) continue;
    ++checking;
    EXPECT_EQ(status.left_s > 0.0, status.checked < status.to_check) << status.checked;
  }
  EXPECT_GT(checking, 1u);
}

TEST_F(TimeLeftTest, IsNoneWhenAllIsDone) {
  EXPECT_EQ(statusesOf(smallRun("a.db")).back().left_s, 0.0);
}

TEST_F(TimeLeftTest, OfARunWithALimitEndsWithTheLimit) {
  LearnOptions options = smallRun("a.db");
  options.validation_trials = 0;
  options.evaluations = 0;
  options.time_budget_s = 20.0;
  for (const LearningStatus& status : statusesOf(options)) {
    EXPECT_LE(status.left_s, 20.0 - std::min(20.0, status.elapsed_s));
  }
}

}  // namespace
}  // namespace hexapod
