#include "execution/leg_doubts.h"

#include <gtest/gtest.h>

#include <memory>

#include "execution/executor_core.h"
#include "shipped_robot.h"

namespace hexapod {
namespace {

constexpr std::size_t kJointsPerLeg = 3;

// An executor and a robot whose legs get stuck, up in the air, or fall silent.
class LegDoubtsTest : public testing::Test {
 protected:
  void make(const ExecutorOptions& options) {
    core_ = std::make_unique<ExecutorCore>(shippedRobot(), BehaviorOptions(), options);
  }

  void SetUp() override {
    Genome genome(shippedRobot().geneCount());
    for (std::size_t i = 0; i < genome.size(); i += 2) genome[i] = 4;  // all amplitudes
    behavior_ = std::make_unique<Behavior>(shippedRobot(), genome, BehaviorOptions());
    make(ExecutorOptions());
    readings_.angles_rad = shippedRobot().neutralPose();
  }

  void step() {
    for (std::size_t j = 0; j < readings_.counts.size(); ++j) {
      if (silent_[j / kJointsPerLeg] == 0) ++readings_.counts[j];
    }
    core_->feedback(readings_);
    const std::vector<double>* command = core_->tick(++slot_);
    if (command == nullptr) return;
    for (std::size_t j = 0; j < command->size(); ++j) {
      if (stuck_[j / kJointsPerLeg] == 0) readings_.angles_rad[j] = (*command)[j];
    }
  }

  void stick(std::size_t leg) {
    stuck_[leg] = 1;
    readings_.angles_rad[kJointsPerLeg * leg + 1] = 1.2;
  }

  void watched(const std::vector<std::size_t>& dead_legs = {}) {
    std::vector<char> dead(shippedRobot().jointCount(), 0);
    for (const std::size_t leg : dead_legs) {
      std::fill_n(dead.begin() + static_cast<std::ptrdiff_t>(kJointsPerLeg * leg), kJointsPerLeg,
                  1);
    }
    core_->tolerate(dead, true);
  }

  void makeReady() {
    step();
    ASSERT_TRUE(core_->arm().accepted());
    for (int i = 0; i < 200 && mode() != ExecutorMode::kReady; ++i) step();
    ASSERT_EQ(mode(), ExecutorMode::kReady);
  }

  // Until the behaviour ends, or there is a fault.
  void play(int commands = 1000) {
    if (mode() == ExecutorMode::kReady) {
      ASSERT_TRUE(core_->start(*behavior_, 1).accepted());
    }
    for (int i = 0; i < commands && mode() == ExecutorMode::kWalking; ++i) step();
  }

  void stand(double seconds) {
    const int periods = static_cast<int>(seconds / BehaviorOptions().command_period_s);
    for (int i = 0; i < periods; ++i) step();
  }

  ExecutorMode mode() const { return core_->status().mode; }
  Reason why() const { return core_->status().cause.reason; }
  std::uint64_t doubted() const { return core_->status().doubted_legs; }

  std::unique_ptr<ExecutorCore> core_;
  std::unique_ptr<Behavior> behavior_;
  JointReadings readings_{shippedRobot().jointCount()};
  std::int64_t slot_ = 0;
  std::vector<char> stuck_ = std::vector<char>(6, 0);
  std::vector<char> silent_ = std::vector<char>(6, 0);
};

TEST_F(LegDoubtsTest, ABrokenLegIsWaitedWithUntilAWholeBehaviourHasShownItAndThenIsAFault) {
  watched();
  makeReady();
  play(40);
  stick(1);
  play();
  EXPECT_EQ(mode(), ExecutorMode::kReady);
  EXPECT_EQ(doubted(), 1u << 1);
  stand(30.0);
  EXPECT_EQ(mode(), ExecutorMode::kReady) << "nothing has shown it yet";
  play();
  EXPECT_EQ(mode(), ExecutorMode::kReady);
  stand(ExecutorOptions().belief_patience_s - 0.1);
  EXPECT_EQ(mode(), ExecutorMode::kReady);
  stand(0.2);
  EXPECT_EQ(mode(), ExecutorMode::kFault);
  EXPECT_EQ(why(), Reason::kNotFollowing);
  EXPECT_EQ(core_->status().cause.joint, static_cast<int>(kJointsPerLeg + 1));
}

TEST_F(LegDoubtsTest, BelievedDeadByThenTheWalkGoesOn) {
  watched();
  makeReady();
  play(40);
  stick(1);
  silent_[4] = 1;
  play();
  play();
  EXPECT_EQ(doubted(), (1u << 1) + (1u << 4));
  watched({1, 4});
  for (int i = 0; i < 5; ++i) {
    play();
    stand(5.0);
    ASSERT_EQ(mode(), ExecutorMode::kReady);
  }
  EXPECT_EQ(doubted(), 0u);
}

TEST_F(LegDoubtsTest, ABehaviourThatIsBrokenOffOrNotWholeShowsNothing) {
  watched();
  makeReady();
  stick(1);
  play(40);
  ++slot_;
  play();
  stand(10.0);
  ASSERT_EQ(mode(), ExecutorMode::kReady);
  EXPECT_EQ(core_->status().last_end.skipped, 1u);
  for (int i = 0; i < 4; ++i) {
    play(40);
    core_->cancel(Reason::kCancelled);
    stand(10.0);
    ASSERT_EQ(mode(), ExecutorMode::kReady);
  }
}

TEST_F(LegDoubtsTest, WhatIsNoTroubleAnyMoreIsNoFaultButIsNotDoubtedAgain) {
  watched();
  makeReady();
  play(40);
  stick(1);
  play();
  stuck_[1] = 0;
  play();
  stand(5.0);
  ASSERT_EQ(mode(), ExecutorMode::kReady);
  EXPECT_EQ(doubted(), 0u);
  stick(1);
  play();
  EXPECT_EQ(why(), Reason::kNotFollowing) << "once between two armings";
  stuck_[1] = 0;
  makeReady();
  stick(1);
  play();
  EXPECT_EQ(mode(), ExecutorMode::kReady);
}

TEST_F(LegDoubtsTest, WhileNobodyWatchesTroubleIsAFaultAtOnce) {
  makeReady();
  play(40);
  stick(1);
  play();
  EXPECT_EQ(why(), Reason::kNotFollowing);
}

TEST_F(LegDoubtsTest, WhoeverWatchedAndIsGoneIsNotWaitedFor) {
  watched();
  makeReady();
  stick(1);
  play();
  ASSERT_EQ(mode(), ExecutorMode::kReady);
  core_->tolerate(std::vector<char>(shippedRobot().jointCount(), 0), false);
  play(40);
  EXPECT_EQ(why(), Reason::kNotFollowing);
}

TEST_F(LegDoubtsTest, NoMoreLegsThanAllowed) {
  ExecutorOptions options;
  options.max_dead_legs = 0;
  make(options);
  watched();
  makeReady();
  stick(1);
  play();
  EXPECT_EQ(why(), Reason::kNotFollowing) << "none is allowed";
  SetUp();
  stuck_[1] = 0;
  watched();
  makeReady();
  watched({0});
  stick(0);
  stick(1);
  play();
  ASSERT_EQ(mode(), ExecutorMode::kReady) << "one dead, one in doubt";
  stick(2);
  play();
  EXPECT_EQ(why(), Reason::kNotFollowing) << "the third";
}

TEST_F(LegDoubtsTest, ADriverThatFallsSilentOrRepeatsItselfIsAFaultAtOnce) {
  watched();
  makeReady();
  play(20);
  silent_.assign(6, 1);
  play();
  EXPECT_EQ(why(), Reason::kFeedbackLost);
  silent_.assign(6, 0);
  makeReady();
  play(20);
  stuck_.assign(6, 1);
  play();
  EXPECT_EQ(why(), Reason::kFeedbackFrozen);
}

TEST_F(LegDoubtsTest, AJointThatWasNeverReadIsNotArmedUnlessItIsBelievedDead) {
  watched();
  silent_[3] = 1;
  step();
  EXPECT_EQ(core_->arm().reason, Reason::kNoFeedback);
  watched({3});
  makeReady();
}

}  // namespace
}  // namespace hexapod
