#include "ros_interface/planner/relearner.h"

#include <gtest/gtest.h>

#include <memory>
#include <thread>

#include "ros_interface/common/conversions.h"
#include "self_model/walked_body.h"

namespace hexapod {
namespace {

// In whose mind no entry of one run is any good.
class Hopeless : public Foresight {
 public:
  explicit Hopeless(std::string run_id) : run_id_(std::move(run_id)) {}
  void observe(const WalkedStep&) override {}
  std::shared_ptr<const Repertoire> expected(
      const std::shared_ptr<const Repertoire>& repertoire) override {
    if (repertoire->run_id != run_id_) return repertoire;
    auto failing = std::make_shared<Repertoire>(*repertoire);
    for (Entry& entry : failing->entries) entry.execution = Execution{{}, 0.0, 0.0, 1, 1};
    return failing;
  }

 private:
  const std::string run_id_;
};

class RelearnerTest : public testing::Test {
 protected:
  RelearnerTest() {
    options_.relearn_evaluations = 60;
    options_.relearn_below = 0.5;
  }

  hexapod_repertoire::Repertoire message(const std::string& run_id) const {
    Repertoire repertoire;
    repertoire.run_id = run_id;
    repertoire.robot_id = robot_.digest;
    repertoire.joint_names = robot_.jointNames();
    for (const Genome& gait : walkingGaits()) {
      Entry entry;
      entry.id = static_cast<std::int64_t>(repertoire.entries.size()) + 1;
      entry.genome = gait;
      WalkedBody body("");
      entry.end_pose = body.walk(gait).startFromEnd();
      repertoire.entries.push_back(entry);
    }
    return toMsg(repertoire, ros::Time(1.0));
  }
  Physics with(const std::string& legs) const {
    Physics body;
    body.legs = legStatesFromText(robot_, legs);
    return body;
  }
  // The next sentence, which comes when it has learned.
  std::string awaitNews(Relearner& relearner, const Physics& body) const {
    while (true) {
      const std::string news = relearner.look(body);
      if (!news.empty()) return news;
      std::this_thread::yield();
    }
  }
  std::string inUse() const { return repertoire_.planner()->repertoire().run_id; }

  const RobotDescription robot_ = shippedRobot();
  PlannerNodeOptions options_;
  RepertoireInUse repertoire_{PlannerOptions(), robot_.digest,
                              [] { return std::vector<std::string>(); },
                              [](const Repertoire&) { return std::make_shared<Hopeless>("run"); }};
  std::vector<Repertoire> published_;
  Relearner relearner_{options_, robot_, repertoire_,
                       [this](const Repertoire& relearned) { published_.push_back(relearned); }};
};

TEST_F(RelearnerTest, LearnsForABodyAndPlansWithItAsLongAsItIsBelieved) {
  repertoire_.take(message("run"), "/server");
  EXPECT_EQ(relearner_.look(std::nullopt), "");
  const Physics body = with("left_middle: lifted");
  const std::string begins = relearner_.look(body);
  EXPECT_EQ(begins.find("With left_middle: lifted, 0 of "), 0u) << begins;
  const std::string news = awaitNews(relearner_, body);
  EXPECT_EQ(news.find("Planning with "), 0u) << news;
  EXPECT_EQ(inUse(), "") << "nobody else knows it";
  EXPECT_GT(repertoire_.planner()->planner()->usableEntries(), 0u);
  ASSERT_EQ(published_.size(), 1u);
  EXPECT_EQ(published_[0].body(), "left_middle: lifted");
  EXPECT_NE(published_[0].run_id, "");
  EXPECT_EQ(relearner_.look(std::nullopt), "") << "unsure for a while";
  EXPECT_EQ(relearner_.look(body), "");
  const std::string mended = relearner_.look(with(""));
  EXPECT_NE(mended.find("the published repertoire again"), std::string::npos) << mended;
  EXPECT_EQ(inUse(), "run");
  ASSERT_EQ(published_.size(), 2u);
  EXPECT_TRUE(published_[1].entries.empty());
}

TEST_F(RelearnerTest, LearnsTheSameAgain) {
  repertoire_.take(message("run"), "/server");
  const Physics body = with("left_middle: lifted");
  for (int i = 0; i < 2; ++i) {
    relearner_.look(body);
    awaitNews(relearner_, body);
    relearner_.look(with(""));
  }
  ASSERT_EQ(published_.size(), 4u);
  ASSERT_EQ(published_[0].entries.size(), published_[2].entries.size());
  for (std::size_t i = 0; i < published_[0].entries.size(); ++i) {
    EXPECT_EQ(published_[0].entries[i].genome, published_[2].entries[i].genome);
  }
}

TEST_F(RelearnerTest, LeavesARepertoireInUseThatHasEnoughLeft) {
  repertoire_.take(message("another run"), "/server");
  EXPECT_EQ(relearner_.look(with("left_middle: lifted")), "");
  EXPECT_FALSE(relearner_.isLearning());
}

TEST_F(RelearnerTest, LeavesAnotherRobotsRepertoireAndWhatItShallNotTouch) {
  Relearner of_no_robot(options_, std::nullopt, repertoire_, [](const Repertoire&) {});
  PlannerNodeOptions never = options_;
  never.relearn_below = 0.0;
  Relearner that_never_does(never, robot_, repertoire_, [](const Repertoire&) {});
  EXPECT_EQ(relearner_.look(with("left_middle: lifted")), "") << "there is none yet";
  repertoire_.take(message("run"), "/server");
  EXPECT_EQ(of_no_robot.look(with("left_middle: lifted")), "");
  EXPECT_EQ(that_never_does.look(with("left_middle: lifted")), "");
}

TEST_F(RelearnerTest, GivesUpWhenItLeavesOrTheRepertoireIsAnother) {
  options_.relearn_evaluations = 1000000000;
  repertoire_.take(message("run"), "/server");
  const Physics body = with("left_middle: lifted");
  relearner_.look(body);
  EXPECT_TRUE(relearner_.isLearning());
  repertoire_.take(message("another run"), "/server");
  EXPECT_EQ(relearner_.look(body), "");
  EXPECT_FALSE(relearner_.isLearning());
  repertoire_.take(message("run"), "/server");
  relearner_.look(body);
  EXPECT_TRUE(relearner_.isLearning());
}

TEST_F(RelearnerTest, TellsWhyNothingCouldBeLearned) {
  auto wrong = message("run");
  wrong.option_names.push_back("command_period_s");
  wrong.option_values.push_back("-1");
  repertoire_.take(wrong, "/server");
  const Physics body = with("left_middle: lifted");
  relearner_.look(body);
  const std::string news = awaitNews(relearner_, body);
  EXPECT_EQ(news.find("Nothing could be learned for left_middle: lifted: "), 0u) << news;
  EXPECT_NE(news.find("command_period_s"), std::string::npos) << news;
  EXPECT_EQ(inUse(), "run");
  EXPECT_EQ(relearner_.look(body), "") << "one try for a body";
}

}  // namespace
}  // namespace hexapod
