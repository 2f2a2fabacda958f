#include "ros_interface/executor/behavior_goals.h"

#include <gtest/gtest.h>

#include <atomic>
#include <map>
#include <thread>

#include "execution/shipped_robot.h"
#include "ros_interface/common/clock.h"

namespace hexapod {
namespace {

using Result = hexapod_repertoire::ExecuteBehaviorResult;

constexpr std::int64_t kPeriod_ns = 30'000'000;

// What the senders of all goals are told, by goal.
struct Told {
  int accepted = 0;
  int feedback = 0;
  std::vector<Result> answers;
  bool refused = false;
};

class FakeSender : public GoalSender {
 public:
  explicit FakeSender(Told& told) : told_(told) {}
  void accepted() override {
    EXPECT_TRUE(told_.answers.empty());
    ++told_.accepted;
  }
  void feedback(const hexapod_repertoire::ExecuteBehaviorFeedback& feedback) override {
    EXPECT_TRUE(told_.answers.empty());
    EXPECT_LE(feedback.elapsed_s, feedback.duration_s);
    ++told_.feedback;
  }
  void ended(const Result& result) override {
    EXPECT_EQ(told_.accepted, 1);
    told_.answers.push_back(result);
  }
  void refused(const Result& result) override {
    EXPECT_EQ(told_.accepted, 0);
    told_.refused = true;
    told_.answers.push_back(result);
  }

 private:
  Told& told_;
};

// An open-loop executor that stands ready; the test is its command loop.
class BehaviorGoalsTest : public testing::Test {
 protected:
  BehaviorGoalsTest() {
    served([this] { EXPECT_TRUE(executor_.arm().accepted()); });
    while (executor_.status().mode != ExecutorMode::kReady) tick(1);
  }

  static ExecutorOptions openLoop() {
    ExecutorOptions options;
    options.feedback_timeout_s = 0.0;
    return options;
  }

  // Calls something that waits for the command loop.
  template <class Call>
  void served(const Call& call) {
    std::atomic<bool> done{false};
    std::thread caller([&] {
      call();
      done = true;
    });
    while (!done) executor_.serve();
    caller.join();
  }
  void tick(int times) {
    for (int i = 0; i < times; ++i, ++slot_) executor_.tick(slot_, slot_ * kPeriod_ns);
  }
  void pollEach(int times) {
    for (int i = 0; i < times; ++i) {
      tick(1);
      goals_.poll(executor_.status());
    }
  }

  void take(const std::string& id, std::size_t genes = shippedRobot().geneCount()) {
    hexapod_repertoire::ExecuteBehaviorGoal goal;
    goal.entry_id = -1;
    goal.genome.assign(genes, 2);
    goals_.take(id, goal, std::make_unique<FakeSender>(told_[id]));
  }
  void send(const std::string& id) {
    served([&] { take(id); });
  }
  void cancel(const std::string& id) {
    served([&] { goals_.cancel(id); });
  }
  Result answer(const std::string& id) {
    EXPECT_EQ(told_[id].answers.size(), 1u) << id;
    return told_[id].answers.empty() ? Result() : told_[id].answers.front();
  }

  // 3 s of gait, 0.6 s back, 0.3 s of rest.
  static constexpr int kCommands = 130;
  SharedExecutor executor_{shippedRobot(), BehaviorOptions(), openLoop()};
  PlayableBehaviors behaviors_{shippedRobot(), BehaviorOptions()};
  BehaviorGoals goals_{{executor_, behaviors_, nullptr,
                        [](std::int64_t slot) { return timeFromNs(slot * kPeriod_ns); },
                        shippedRobot().jointNames(), 0.030}};
  std::map<std::string, Told> told_;
  std::int64_t slot_ = 0;
};

TEST_F(BehaviorGoalsTest, ABehaviourThatIsPlayedToItsEndSucceeds) {
  const std::int64_t first_slot = slot_;
  send("a");
  EXPECT_EQ(told_["a"].accepted, 1);
  pollEach(kCommands);
  EXPECT_TRUE(told_["a"].answers.empty()) << "its last command is out, its end has not come";
  EXPECT_NEAR(told_["a"].feedback, 3.9 / 0.2, 3.0);
  pollEach(1);
  EXPECT_EQ(answer("a").code, Result::SUCCEEDED) << answer("a").message;
  EXPECT_EQ(answer("a").finished, timeFromNs((first_slot + kCommands - 1) * kPeriod_ns));
  pollEach(10);
  EXPECT_EQ(told_["a"].answers.size(), 1u);
}

TEST_F(BehaviorGoalsTest, EveryGoalOfABurstIsRefusedAndTheOnePlayedIsNotDisturbed) {
  send("a");
  pollEach(10);
  for (int i = 0; i < 1000; ++i) take(std::to_string(i));  // nobody serves: the loop is not asked
  for (int i = 0; i < 1000; ++i) {
    EXPECT_TRUE(told_[std::to_string(i)].refused);
    EXPECT_EQ(answer(std::to_string(i)).code, Result::NOT_READY);
  }
  pollEach(kCommands);
  EXPECT_EQ(answer("a").code, Result::SUCCEEDED);
}

// A client that looks at the executor's state sends the next one before the node has polled.
TEST_F(BehaviorGoalsTest, AGoalThatComesRightAfterTheEndTakesNobodysAnswer) {
  send("a");
  tick(kCommands + 1);
  ASSERT_EQ(executor_.status().mode, ExecutorMode::kReady);
  send("b");
  EXPECT_EQ(answer("a").code, Result::SUCCEEDED);
  EXPECT_EQ(told_["b"].accepted, 1);
  pollEach(kCommands + 1);
  EXPECT_EQ(answer("b").code, Result::SUCCEEDED);
  EXPECT_EQ(told_["a"].answers.size(), 1u);
}

TEST_F(BehaviorGoalsTest, ACancelBreaksItsOwnGoalOffAndNoOther) {
  send("a");
  pollEach(20);
  cancel("b");
  EXPECT_EQ(executor_.status().mode, ExecutorMode::kWalking);
  cancel("a");
  EXPECT_EQ(executor_.status().mode, ExecutorMode::kHolding);
  while (told_["a"].answers.empty()) pollEach(1);
  EXPECT_EQ(answer("a").code, Result::PREEMPTED);
  cancel("a");
  send("b");
  cancel("a");
  EXPECT_EQ(executor_.status().mode, ExecutorMode::kWalking) << "a late cancel of another goal";
}

TEST_F(BehaviorGoalsTest, ACancelAfterTheEndChangesNoAnswer) {
  send("a");
  tick(kCommands + 1);
  cancel("a");
  goals_.poll(executor_.status());
  EXPECT_EQ(answer("a").code, Result::SUCCEEDED);
}

TEST_F(BehaviorGoalsTest, AStopEndsTheGoalAndRefusesTheNext) {
  send("a");
  pollEach(20);
  executor_.stop(Reason::kStopRequested);
  pollEach(1);
  EXPECT_EQ(answer("a").code, Result::STOPPED);
  send("b");
  EXPECT_EQ(answer("b").code, Result::NOT_READY);
}

TEST_F(BehaviorGoalsTest, WhatIsNoBehaviourIsRefusedWithASentence) {
  take("a", 3);
  EXPECT_TRUE(told_["a"].refused);
  EXPECT_EQ(answer("a").code, Result::INVALID_GOAL);
  EXPECT_NE(answer("a").message.find('3'), std::string::npos) << answer("a").message;
  EXPECT_EQ(executor_.status().mode, ExecutorMode::kReady);
}

TEST_F(BehaviorGoalsTest, ANodeThatLeavesAnswersTheGoalUnderWay) {
  goals_.abort("nothing is under way");
  send("a");
  pollEach(20);
  goals_.abort("The executor is shutting down.");
  EXPECT_EQ(answer("a").code, Result::STOPPED);
  EXPECT_EQ(answer("a").message, "The executor is shutting down.");
  pollEach(kCommands);
  EXPECT_EQ(told_["a"].answers.size(), 1u);
}

}  // namespace
}  // namespace hexapod
