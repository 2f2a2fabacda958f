#include "ros_interface/robot_client/executor_client.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "ros_interface/fake_clock.h"

namespace hexapod {
namespace {

using ActionGoal = hexapod_repertoire::ExecuteBehaviorActionGoal;
using ActionResult = hexapod_repertoire::ExecuteBehaviorActionResult;
using Answer = hexapod_repertoire::ExecuteBehaviorResult;
using End = BehaviorPlayer::End;
using State = hexapod_repertoire::ExecutorState;
using Status = actionlib_msgs::GoalStatus;

constexpr double kBehavior_s = 3.9;

// An executor at the other end of the wire, on the same clock: states once a second, feedback five
// times, a result after 3.9 s of ROS time.
class ExecutorClientTest : public testing::Test, public ExecutorWire {
 protected:
  ExecutorClientTest() {
    clock_.on_step = [this] { live(); };
    tell(State::READY);
  }

  bool isConnected() const override { return connected_; }
  void send(const ActionGoal& goal) override {
    goals_.push_back(goal);
    begun_ = clock_.rosNow();
    if (refusals_ > 0) {
      --refusals_;
      return answer(Status::REJECTED, Answer::NOT_READY, 0);
    }
    playing_ = true;
  }
  void cancel(const actionlib_msgs::GoalID& id) override {
    cancelled_.push_back(id.id);
    if (playing_ && alive_ && answers_cancels_) answer(Status::PREEMPTED, Answer::PREEMPTED, 0);
  }

  void tell(std::uint8_t state) {
    state_ = state;
    State message;
    message.state = state;
    message.header.stamp = clock_.rosNow();
    client_.onState(message);
  }
  void answer(std::uint8_t status, std::uint8_t code, std::uint32_t skipped) {
    playing_ = false;
    ActionResult result;
    result.status.goal_id = goals_.back().goal_id;
    result.status.status = status;
    result.result.code = code;
    result.result.skipped = skipped;
    result.result.finished = clock_.rosNow();
    result.result.joint_min_rad = {-0.1, NAN};
    result.result.joint_max_rad = {0.2, NAN};
    client_.onResult(result);
  }
  void live() {
    if (on_live) on_live();
    const std::int64_t now_ns = clock_.steadyNow_ns();
    if (!alive_ || now_ns % (kSecond_ns / 5) != 0) return;
    if (now_ns % kSecond_ns == 0) tell(state_);
    if (!playing_) return;
    const double played_s = (clock_.rosNow() - begun_).toSec();
    if (played_s >= kBehavior_s) return answer(Status::SUCCEEDED, Answer::SUCCEEDED, 0);
    if (played_s == fed_back_s_) return;
    fed_back_s_ = played_s;
    hexapod_repertoire::ExecuteBehaviorActionFeedback feedback;
    feedback.status.goal_id = goals_.back().goal_id;
    client_.onFeedback(feedback);
  }

  BehaviorPlayer::Result play(const std::function<bool()>& interrupted = [] { return false; }) {
    begin_ns_ = clock_.steadyNow_ns();
    return client_.play({entry_, "run", client_.stops(), interrupted});
  }
  double played_s() const { return 1e-9 * static_cast<double>(clock_.steadyNow_ns() - begin_ns_); }

  FakeClock clock_;
  ExecutorClient client_{clock_, *this, "/planner"};
  Entry entry_;
  std::function<void()> on_live;
  bool connected_ = true;
  bool alive_ = true;
  bool playing_ = false;
  bool answers_cancels_ = true;
  int refusals_ = 0;
  std::uint8_t state_ = State::READY;
  ros::Time begun_;
  double fed_back_s_ = -1.0;
  std::int64_t begin_ns_ = 0;
  std::vector<ActionGoal> goals_;
  std::vector<std::string> cancelled_;
};

TEST_F(ExecutorClientTest, HasABehaviourPlayedToItsEnd) {
  entry_.id = 7;
  const auto result = play();
  EXPECT_EQ(result.end, End::kPlayed) << result.message;
  EXPECT_NEAR(played_s(), kBehavior_s, 0.3);
  EXPECT_EQ(goals_.at(0).goal.entry_id, 7);
  EXPECT_EQ(goals_.at(0).goal.run_id, "run");
  EXPECT_FALSE(result.finished.isZero());
  ASSERT_EQ(result.joints.size(), 2u);
  EXPECT_EQ(result.joints[0].min_rad, -0.1);
  EXPECT_EQ(result.joints[0].max_rad, 0.2);
  EXPECT_TRUE(std::isnan(result.joints[1].min_rad));
  play();
  EXPECT_NE(goals_.at(0).goal_id.id, goals_.at(1).goal_id.id);
}

TEST_F(ExecutorClientTest, OfARunThatNobodyPublishesTheGenomeAloneIsSent) {
  entry_.id = 7;
  entry_.genome = {1, 2, 3};
  EXPECT_EQ(client_.play({entry_, "", client_.stops(), [] { return false; }}).end, End::kPlayed);
  EXPECT_EQ(goals_.at(0).goal.entry_id, -1);
  EXPECT_EQ(goals_.at(0).goal.run_id, "");
  EXPECT_EQ(goals_.at(0).goal.genome, (std::vector<std::uint8_t>{1, 2, 3}));
}

TEST_F(ExecutorClientTest, SaysWhyTheExecutorIsNotReadyAndWhatToDo) {
  EXPECT_EQ(client_.whyNotReady(), "");
  for (const std::uint8_t state :
       {State::DISARMED, State::STOPPED, State::FAULT, State::SITTING_DOWN}) {
    tell(state);
    EXPECT_NE(client_.whyNotReady().find("executor/arm"), std::string::npos);
    EXPECT_EQ(play().end, End::kNotReady);
  }
  for (const std::uint8_t state :
       {State::STANDING_UP, State::READY, State::WALKING, State::HOLDING}) {
    tell(state);
    EXPECT_EQ(client_.whyNotReady(), "");
  }
  connected_ = false;
  EXPECT_FALSE(client_.whyNotReady().empty());
  const ExecutorClient deaf(clock_, *this, "/planner");
  EXPECT_NE(deaf.whyNotReady().find("start the executor"), std::string::npos);
  EXPECT_TRUE(goals_.empty());
}

TEST_F(ExecutorClientTest, WaitsForAnExecutorThatWillBeReadySoon) {
  tell(State::STANDING_UP);
  const std::int64_t ready_ns = clock_.steadyNow_ns() + 2 * kSecond_ns;
  on_live = [&] {
    if (state_ == State::STANDING_UP && clock_.steadyNow_ns() >= ready_ns) tell(State::READY);
  };
  EXPECT_EQ(play().end, End::kPlayed);
  tell(State::STANDING_UP);
  on_live = nullptr;
  EXPECT_EQ(play().end, End::kNotReady);
  EXPECT_NEAR(played_s(), 5.0, 0.2);
  EXPECT_EQ(goals_.size(), 1u);
}

TEST_F(ExecutorClientTest, TellsSinceWhenTheRobotHasStood) {
  tell(State::HOLDING);
  const std::int64_t ready_ns = clock_.steadyNow_ns() + 2 * kSecond_ns;
  ros::Time since;
  on_live = [&] {
    if (state_ != State::HOLDING || clock_.steadyNow_ns() < ready_ns) return;
    since = clock_.rosNow();
    tell(State::READY);
  };
  const auto never = [] { return false; };
  auto result = client_.awaitReady(client_.stops(), never);
  EXPECT_EQ(result.end, End::kPlayed) << result.message;
  EXPECT_EQ(result.finished, since);
  EXPECT_FALSE(since.isZero());
  play();  // its state is told again once a second
  EXPECT_EQ(client_.awaitReady(client_.stops(), never).finished, since);
  tell(State::HOLDING);
  on_live = nullptr;
  EXPECT_EQ(client_.awaitReady(client_.stops(), [] { return true; }).end, End::kCancelled);
  EXPECT_EQ(client_.awaitReady(client_.stops(), never).end, End::kNotReady);
  EXPECT_EQ(goals_.size(), 1u);
}

TEST_F(ExecutorClientTest, AsksAgainWhenSomebodyElseCameFirst) {
  refusals_ = 2;
  EXPECT_EQ(play().end, End::kPlayed);
  EXPECT_EQ(goals_.size(), 3u);
}

TEST_F(ExecutorClientTest, NothingBeginsAfterAStopThatCameSinceTheGoal) {
  const std::uint64_t stops = client_.stops();
  tell(State::STOPPED);
  tell(State::STANDING_UP);
  tell(State::READY);
  EXPECT_EQ(client_.play({entry_, "run", stops, [] { return false; }}).end, End::kNotReady);
  EXPECT_TRUE(goals_.empty());
}

TEST_F(ExecutorClientTest, BreaksOffWhenInterruptedAndWaitsForTheAnswer) {
  const auto result = play([this] { return played_s() > 1.0; });
  EXPECT_EQ(result.end, End::kCancelled);
  EXPECT_EQ(cancelled_, std::vector<std::string>{goals_.at(0).goal_id.id});
  EXPECT_LE(played_s(), 1.1);
}

TEST_F(ExecutorClientTest, LeavesAnExecutorThatDoesNotAnswerACancel) {
  answers_cancels_ = false;
  EXPECT_EQ(play([this] { return played_s() > 1.0; }).end, End::kCancelled);
  EXPECT_LE(played_s(), 1.7);
}

TEST_F(ExecutorClientTest, WaitsForNoAnswerWhileTimeStands) {
  answers_cancels_ = false;
  on_live = [this] {
    if (played_s() >= 1.0) clock_.setRate(0.0);
  };
  EXPECT_EQ(play([this] { return played_s() > 2.0; }).end, End::kCancelled);
  EXPECT_LE(played_s(), 2.2);
}

TEST_F(ExecutorClientTest, ASilentExecutorIsToldWithinTwoSeconds) {
  on_live = [this] { alive_ = played_s() < 1.0; };
  EXPECT_EQ(play().end, End::kFault);
  EXPECT_LE(played_s(), 3.0);
  EXPECT_FALSE(client_.whyNotReady().empty());
}

TEST_F(ExecutorClientTest, AMomentInWhichWeDidNotRunIsNotTheExecutorsSilence) {
  bool stalled = false;
  const auto stall = [&] {
    if (stalled || played_s() < 1.0) return false;
    stalled = true;
    alive_ = false;
    clock_.pass(5 * kSecond_ns);
    alive_ = true;  // and what it told is heard now
    return false;
  };
  EXPECT_EQ(play(stall).end, End::kPlayed);
  EXPECT_TRUE(stalled);
}

TEST_F(ExecutorClientTest, AnExecutorWhoseConnectionBrokeIsToldAtOnce) {
  on_live = [this] { connected_ = played_s() < 1.0; };
  EXPECT_EQ(play().end, End::kFault);
  EXPECT_LE(played_s(), 1.1);
}

TEST_F(ExecutorClientTest, AnExecutorThatTellsNothingOfTheBehaviourIsGivenUp) {
  on_live = [this] { playing_ = false; };
  EXPECT_EQ(play().end, End::kFault);
  EXPECT_NEAR(played_s(), 3.0, 0.2);
  EXPECT_EQ(cancelled_.size(), 1u);
}

TEST_F(ExecutorClientTest, TimeThatStandsIsToldWithinTwoSeconds) {
  on_live = [this] {
    if (played_s() >= 1.0) clock_.setRate(0.0);
  };
  EXPECT_EQ(play().end, End::kTimeStands);
  EXPECT_LE(played_s(), 2.8);
}

TEST_F(ExecutorClientTest, ClocksThatAreSetDisturbNothing) {
  for (const double set_s : {10.0, 5000.0, 1e6}) {
    bool set = false;
    on_live = [&] {
      if (set || played_s() < 1.0) return;
      // The executor goes on by its own count.
      const ros::Duration played = clock_.rosNow() - begun_;
      clock_.setRos(set_s);
      begun_ = clock_.rosNow() - played;
      set = true;
    };
    EXPECT_EQ(play().end, End::kPlayed);
    EXPECT_NEAR(played_s(), kBehavior_s, 0.3);
  }
}

TEST_F(ExecutorClientTest, SlowSimulatedTimeIsNoFault) {
  clock_.setRate(0.05);
  EXPECT_EQ(play().end, End::kPlayed);
  EXPECT_NEAR(played_s(), kBehavior_s / 0.05, 5.0);
}

TEST_F(ExecutorClientTest, TellsHowManyCommandsWereSkipped) {
  on_live = [this] {
    if (playing_ && played_s() > 1.0) answer(Status::ABORTED, Answer::SKIPPED, 166);
  };
  const auto result = play();
  EXPECT_EQ(result.end, End::kPlayed);
  EXPECT_EQ(result.skipped, 166u);
}

// actionlib ends a goal that its cancel overtook with an empty result, whose code is SUCCEEDED.
TEST_F(ExecutorClientTest, ARecalledGoalWasNotPlayed) {
  on_live = [this] {
    if (playing_ && played_s() > 1.0) answer(Status::RECALLED, 0, 0);
  };
  EXPECT_EQ(play().end, End::kCancelled);
}

TEST_F(ExecutorClientTest, AnswersToOthersAreNotItsOwn) {
  on_live = [this] {
    if (!playing_) return;
    ActionResult result;
    result.status.goal_id.id = "somebody else's";
    result.status.status = Status::ABORTED;
    client_.onResult(result);
  };
  EXPECT_EQ(play().end, End::kPlayed);
}

}  // namespace
}  // namespace hexapod
