#include "execution/belief_judge.h"

#include <gtest/gtest.h>

#include "shipped_robot.h"

namespace hexapod {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;

class BeliefJudgeTest : public testing::Test {
 protected:
  ToldBelief told(std::vector<std::string> dead_joints = {}) const {
    ToldBelief told;
    told.publisher = "/planner";
    told.robot_id = shippedRobot().digest;
    told.dead_joints = std::move(dead_joints);
    told.stamp_ns = 100 * kSecond_ns;
    told.arrival = {told.stamp_ns, now_ns_};
    told.steady_now_ns = now_ns_;
    return told;
  }

  void expectLeftOut(const std::string& because) const {
    EXPECT_EQ(judge_.tolerance(now_ns_), JointTolerance());
    EXPECT_NE(judge_.problem(now_ns_).find(because), std::string::npos) << judge_.problem(now_ns_);
  }

  std::int64_t now_ns_ = 7 * kSecond_ns;
  BeliefJudge judge_{shippedRobot(), 2};
};

TEST_F(BeliefJudgeTest, ToleratesTheJointsThatAreToldDead) {
  EXPECT_EQ(judge_.tolerance(now_ns_), JointTolerance());
  judge_.hear(told());
  EXPECT_EQ(judge_.tolerance(now_ns_), (JointTolerance{{}, true}));
  judge_.hear(told({"leg_1_1_2", "body_leg_1"}));
  EXPECT_EQ(judge_.tolerance(now_ns_), (JointTolerance{{3, 4}, true}));
  EXPECT_EQ(judge_.problem(now_ns_), "");
}

TEST_F(BeliefJudgeTest, ToleratesNothingOnceNobodyTells) {
  judge_.hear(told({"body_leg_1"}));
  now_ns_ += 4 * kSecond_ns;
  EXPECT_EQ(judge_.tolerance(now_ns_), JointTolerance());
}

TEST_F(BeliefJudgeTest, LeavesOutWhatIsNotAboutThisRobotNow) {
  ToldBelief other = told();
  other.robot_id = "another";
  judge_.hear(other);
  expectLeftOut("another");
  judge_.hear(told({"antenna"}));
  expectLeftOut("'antenna'");
  ToldBelief recorded = told();
  recorded.stamp_ns -= 60 * kSecond_ns;
  judge_.hear(recorded);
  expectLeftOut("60000 ms ago");
}

TEST_F(BeliefJudgeTest, BelievesOnWhenTheClockIsSetWhileItIsTold) {
  judge_.hear(told({"body_leg_1"}));
  now_ns_ += kSecond_ns;
  ToldBelief on_its_way = told({"body_leg_1"});
  on_its_way.stamp_ns += kSecond_ns;
  on_its_way.arrival.ros_ns -= 3600 * kSecond_ns;
  judge_.hear(on_its_way);
  EXPECT_EQ(judge_.tolerance(now_ns_).dead.size(), 1u);
  EXPECT_EQ(judge_.problem(now_ns_), "");
  now_ns_ += kSecond_ns;
  ToldBelief after = told({"body_leg_1"});
  after.stamp_ns = after.arrival.ros_ns = -3500 * kSecond_ns;
  judge_.hear(after);
  EXPECT_EQ(judge_.tolerance(now_ns_).dead.size(), 1u);
}

TEST_F(BeliefJudgeTest, LeavesOutMoreLegsThanAllowed) {
  judge_.hear(told({"body_leg_1", "leg_1_1_2", "body_leg_2"}));
  EXPECT_EQ(judge_.tolerance(now_ns_).dead.size(), 3u);
  judge_.hear(told({"body_leg_1", "body_leg_2", "body_leg_3"}));
  expectLeftOut("3 legs");
}

TEST_F(BeliefJudgeTest, BelievesNeitherOfTwo) {
  judge_.hear(told({"body_leg_1"}));
  ToldBelief rival = told();
  rival.publisher = "/other";
  judge_.hear(rival);
  expectLeftOut("/other and /planner");
  now_ns_ += 2 * kSecond_ns;
  judge_.hear(told({"body_leg_1"}));
  now_ns_ += 2 * kSecond_ns;
  EXPECT_EQ(judge_.tolerance(now_ns_).dead.size(), 1u) << "the other is gone";
}

TEST_F(BeliefJudgeTest, DoesWithoutLegsThatAPersonSaysAreNotThere) {
  BeliefJudge judge(shippedRobot(), 2, "left_middle");
  EXPECT_EQ(judge.tolerance(now_ns_), (JointTolerance{{3, 4, 5}, false}));
  judge.hear(told({"leg_1_1_2", "body_leg_2"}));
  EXPECT_EQ(judge.tolerance(now_ns_), (JointTolerance{{3, 4, 5, 6}, true}));
  now_ns_ += 4 * kSecond_ns;
  EXPECT_EQ(judge.tolerance(now_ns_), (JointTolerance{{3, 4, 5}, false}));
  EXPECT_EQ(
      BeliefJudge(shippedRobot(), 0, " left_middle ,right_rear").tolerance(now_ns_).dead.size(),
      6u);
}

TEST_F(BeliefJudgeTest, NamesTheLegsThereAreWhenItIsToldOfAnother) {
  try {
    const BeliefJudge judge(shippedRobot(), 2, "left_middle, tail");
    FAIL() << judge.problem(now_ns_);
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("'tail'"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("right_rear"), std::string::npos) << error.what();
  }
}

TEST_F(BeliefJudgeTest, ToleratesNothingWhereNothingMayBe) {
  BeliefJudge strict(shippedRobot(), 0);
  strict.hear(told());
  EXPECT_EQ(strict.tolerance(now_ns_), JointTolerance());
}

}  // namespace
}  // namespace hexapod
