#include "execution/executor_core.h"

#include <gtest/gtest.h>

#include <memory>

#include "execution/sitting_pose.h"
#include "gait/random_genome.h"
#include "shipped_robot.h"

namespace hexapod {
namespace {

// An executor and the robot it drives: feedback is what was commanded, unless a test says
// otherwise.
class ExecutorCoreTest : public testing::Test {
 protected:
  void make(const ExecutorOptions& options, const BehaviorOptions& behavior = {}) {
    core_ = std::make_unique<ExecutorCore>(shippedRobot(), behavior, options);
  }

  void SetUp() override {
    Random random(3);
    behavior_ = std::make_unique<Behavior>(shippedRobot(), randomGenome(random), BehaviorOptions());
    make(ExecutorOptions());
    measured_ = neutral_;
  }

  // One command period with feedback; the command or an empty vector.
  std::vector<double> step(std::int64_t periods = 1) {
    if (!silent_) core_->feedback(driver_.read(measured_));
    slot_ += periods;
    const std::vector<double>* command = core_->tick(slot_);
    if (command == nullptr) return {};
    if (!blocked_) measured_ = *command;
    return *command;
  }

  void stepUntil(ExecutorMode mode) {
    for (int i = 0; i < 1000 && this->mode() != mode; ++i) step();
    ASSERT_EQ(this->mode(), mode) << sentence(core_->status().cause, shippedRobot().jointNames());
  }

  void makeReady() {
    step();
    ASSERT_TRUE(core_->arm().accepted());
    stepUntil(ExecutorMode::kReady);
  }

  void startWalking(int commands) {
    makeReady();
    ASSERT_TRUE(core_->start(*behavior_, 5).accepted());
    for (int i = 0; i < commands; ++i) step();
  }

  ExecutorMode mode() const { return core_->status().mode; }
  Reason endReason() const { return core_->status().last_end.cause.reason; }

  const std::vector<double> neutral_ = shippedRobot().neutralPose();
  std::unique_ptr<Behavior> behavior_;
  std::unique_ptr<ExecutorCore> core_;
  std::vector<double> measured_;
  WholeRobotDriver driver_;
  std::int64_t slot_ = 0;
  bool silent_ = false;
  bool blocked_ = false;
};

TEST_F(ExecutorCoreTest, SendsNothingUntilArmed) {
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(step().empty());
  EXPECT_EQ(mode(), ExecutorMode::kDisarmed);
}

TEST_F(ExecutorCoreTest, StandsUpFromTheMeasuredPose) {
  measured_[1] = 0.9;
  step();
  ASSERT_TRUE(core_->arm().accepted());
  EXPECT_EQ(mode(), ExecutorMode::kStandingUp);
  const std::vector<double> first = step();
  EXPECT_DOUBLE_EQ(first[1], 0.9);
  EXPECT_LT(std::abs(step()[1] - 0.9), 0.01) << "a ramp begins at rest";
  stepUntil(ExecutorMode::kReady);
  EXPECT_EQ(step(), neutral_);
  // 2 s of ramp in periods of 30 ms.
  EXPECT_GE(core_->status().commands, 67u);
}

TEST_F(ExecutorCoreTest, ArmsOnlyWithFeedbackUnlessOpenLoop) {
  EXPECT_EQ(core_->arm().reason, Reason::kNoFeedback);
  step();
  silent_ = true;
  for (int i = 0; i < 30; ++i) step();
  EXPECT_EQ(core_->arm().reason, Reason::kNoFeedback) << "the feedback is 0.9 s old";
  ExecutorOptions open_loop;
  open_loop.feedback_timeout_s = 0.0;
  make(open_loop);
  EXPECT_TRUE(core_->arm().accepted());
  EXPECT_EQ(step(), neutral_);
}

TEST_F(ExecutorCoreTest, RefusesAFarStartByOptionAndNamesTheJoint) {
  ExecutorOptions options;
  options.far_start = FarStart::kRefuse;
  make(options);
  measured_[7] = -0.5;
  step();
  const Cause cause = core_->arm();
  EXPECT_EQ(cause.reason, Reason::kFarFromNeutral);
  const std::string text = sentence(cause, shippedRobot().jointNames());
  EXPECT_NE(text.find("leg_2_1_2"), std::string::npos) << text;
  EXPECT_NE(text.find("0.5 rad"), std::string::npos) << text;
  EXPECT_TRUE(step().empty());
  measured_[7] = -0.1;
  step();
  EXPECT_TRUE(core_->arm().accepted());
}

TEST_F(ExecutorCoreTest, PlaysABehaviorCommandByCommand) {
  makeReady();
  ASSERT_TRUE(core_->start(*behavior_, 42).accepted());
  EXPECT_EQ(core_->status().entry_id, 42);
  const std::int64_t first_slot = slot_ + 1;
  const auto count = static_cast<std::int64_t>(behavior_->commandCount());
  for (std::int64_t k = 0; k < count; ++k) {
    EXPECT_EQ(step(), behavior_->command(static_cast<std::size_t>(k))) << k;
    EXPECT_EQ(mode(), ExecutorMode::kWalking);
    EXPECT_EQ(core_->status().played, k);
  }
  EXPECT_EQ(step(), neutral_);
  EXPECT_EQ(mode(), ExecutorMode::kReady);
  EXPECT_EQ(endReason(), Reason::kFinished);
  EXPECT_EQ(core_->status().last_end.serial, 1u);
  EXPECT_EQ(core_->status().last_end.last_slot, first_slot + count - 1);
  EXPECT_EQ(core_->status().skipped, 0u);
  EXPECT_EQ(core_->status().clamped, 0u);
  EXPECT_EQ(core_->status().entry_id, -1);
}

TEST_F(ExecutorCoreTest, PlaysOneBehaviorAtATimeAndOnlyWhenReady) {
  EXPECT_EQ(core_->start(*behavior_, 1).reason, Reason::kNotReady);
  startWalking(3);
  const Cause second = core_->start(*behavior_, 2);
  EXPECT_EQ(second.reason, Reason::kNotReady);
  EXPECT_EQ(second.mode, ExecutorMode::kWalking);
  EXPECT_EQ(core_->status().entry_id, 5);
}

TEST_F(ExecutorCoreTest, AStallSkipsToTheTimelineWithinTheVelocityLimit) {
  startWalking(10);
  const std::vector<double> before = measured_;
  // 200 ms later: periods 10 .. 15 are gone, this is command 16.
  const std::vector<double> after = step(7);
  EXPECT_EQ(core_->status().skipped, 6u);
  EXPECT_LE(largestStep(before, after), 6.28 * 0.030 * (1.0 + 1e-8));
  for (int k = 17; k < 40; ++k) step();
  EXPECT_EQ(step(), behavior_->command(40)) << "caught up, on the timeline";
  stepUntil(ExecutorMode::kReady);
  EXPECT_EQ(endReason(), Reason::kFinished);
  EXPECT_EQ(core_->status().last_end.skipped, 6u);
  ASSERT_TRUE(core_->start(*behavior_, 5).accepted());
  stepUntil(ExecutorMode::kReady);
  EXPECT_EQ(core_->status().last_end.skipped, 0u) << "those of the behaviour before do not count";
}

TEST_F(ExecutorCoreTest, AStallBeyondTheEndStillEndsInNeutralSmoothly) {
  startWalking(20);
  std::vector<double> before = measured_;
  std::vector<double> after = step(1000);
  for (int i = 0; i < 50 && mode() == ExecutorMode::kWalking; ++i) {
    EXPECT_LE(largestStep(before, after), 6.28 * 0.030 * (1.0 + 1e-8));
    before = after;
    after = step();
  }
  EXPECT_EQ(mode(), ExecutorMode::kReady);
  EXPECT_EQ(after, neutral_);
  // 20 of the behaviour's 130 commands were sent.
  EXPECT_EQ(core_->status().last_end.skipped, 110u);
}

TEST_F(ExecutorCoreTest, ABehaviorThatEndsAfterTheGaitIsBroughtBackToNeutral) {
  BehaviorOptions paper;
  paper.end_pose = EndPose::kAfterGait;
  make(ExecutorOptions(), paper);
  Random random(5);
  behavior_ = std::make_unique<Behavior>(shippedRobot(), randomGenome(random), paper);
  startWalking(static_cast<int>(behavior_->commandCount()));
  ASSERT_GT(largestStep(measured_, neutral_), 0.1);
  stepUntil(ExecutorMode::kReady);
  EXPECT_EQ(measured_, neutral_);
}

TEST_F(ExecutorCoreTest, CancelHoldsThenReturnsToNeutral) {
  startWalking(30);
  const std::vector<double> last = measured_;
  ASSERT_TRUE(core_->cancel(Reason::kCancelled).accepted());
  EXPECT_EQ(mode(), ExecutorMode::kHolding);
  for (int i = 0; i < 7; ++i) EXPECT_EQ(step(), last) << "0.2 s held";
  EXPECT_EQ(core_->start(*behavior_, 6).reason, Reason::kNotReady);
  stepUntil(ExecutorMode::kReady);
  EXPECT_EQ(endReason(), Reason::kCancelled);
  EXPECT_EQ(step(), neutral_);
  EXPECT_EQ(core_->cancel(Reason::kCancelled).reason, Reason::kNothingToCancel);
}

TEST_F(ExecutorCoreTest, StopSendsNothingMoreInAnyMode) {
  const auto expectSilence = [this](ExecutorMode expected) {
    EXPECT_EQ(mode(), expected);
    for (int i = 0; i < 200; ++i) EXPECT_TRUE(step().empty());
  };
  core_->stop(Reason::kStopRequested);
  expectSilence(ExecutorMode::kStopped);
  ASSERT_TRUE(core_->arm().accepted());
  step();
  core_->stop(Reason::kStopRequested);
  expectSilence(ExecutorMode::kStopped);
  startWalking(10);
  core_->stop(Reason::kStopRequested);
  EXPECT_EQ(endReason(), Reason::kStopRequested);
  expectSilence(ExecutorMode::kStopped);
  EXPECT_EQ(core_->start(*behavior_, 1).reason, Reason::kNotReady);
  EXPECT_EQ(core_->stand().reason, Reason::kStopRequested);
  EXPECT_TRUE(core_->disarm().accepted());
  expectSilence(ExecutorMode::kStopped);
}

TEST_F(ExecutorCoreTest, TheEmergencyStopLocksUntilReleasedAndArmed) {
  startWalking(10);
  core_->setEStop(true);
  EXPECT_EQ(mode(), ExecutorMode::kStopped);
  EXPECT_EQ(core_->arm().reason, Reason::kEStop);
  core_->setEStop(false);
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(step().empty()) << "releasing does not arm";
  EXPECT_TRUE(core_->arm().accepted());
  EXPECT_FALSE(step().empty());
}

TEST_F(ExecutorCoreTest, FaultsWhenFeedbackIsLostAndArmsAgainWhenItIsBack) {
  startWalking(10);
  silent_ = true;
  int sent = 0;
  while (!step().empty() && sent < 100) ++sent;
  // 0.5 s of silence are 16 periods and a part.
  EXPECT_NEAR(sent, 17, 1);
  EXPECT_EQ(mode(), ExecutorMode::kFault);
  EXPECT_EQ(endReason(), Reason::kFeedbackLost);
  EXPECT_EQ(core_->arm().reason, Reason::kNoFeedback);
  silent_ = false;
  EXPECT_TRUE(step().empty());
  EXPECT_TRUE(core_->arm().accepted());
}

TEST_F(ExecutorCoreTest, AStallOfTheWholeProcessIsNoLossOfFeedback) {
  startWalking(10);
  silent_ = true;
  EXPECT_FALSE(step(100).empty());
  silent_ = false;
  EXPECT_FALSE(step().empty());
}

TEST_F(ExecutorCoreTest, FaultsWhenAServoDoesNotFollow) {
  makeReady();
  std::vector<std::uint8_t> levels(shippedRobot().geneCount(), 0);
  levels[0] = 4;  // amplitude of the first joint of the first leg
  levels[2] = 4;
  const Behavior behavior(shippedRobot(), levels, BehaviorOptions());
  ASSERT_TRUE(core_->start(behavior, 1).accepted());
  blocked_ = true;
  for (int i = 0; i < 100 && mode() == ExecutorMode::kWalking; ++i) step();
  EXPECT_EQ(mode(), ExecutorMode::kFault);
  const Cause cause = core_->status().cause;
  EXPECT_EQ(cause.reason, Reason::kNotFollowing);
  EXPECT_GT(cause.value_rad, 0.5);
  EXPECT_EQ(cause.joint % 3 != 0, true) << "0.39 rad of the first joint is within tolerance";
}

TEST_F(ExecutorCoreTest, SitsDownAndStandsUpAgain) {
  EXPECT_EQ(core_->sit().reason, Reason::kNotReady);
  makeReady();
  ASSERT_TRUE(core_->sit().accepted());
  EXPECT_EQ(mode(), ExecutorMode::kSittingDown);
  stepUntil(ExecutorMode::kDisarmed);
  EXPECT_EQ(measured_, sittingPose(shippedRobot(), 1.0));
  EXPECT_TRUE(step().empty());
  ASSERT_TRUE(core_->stand().accepted());
  stepUntil(ExecutorMode::kReady);
}

TEST_F(ExecutorCoreTest, DisarmBreaksOffAndSendsNothing) {
  startWalking(10);
  EXPECT_TRUE(core_->disarm().accepted());
  EXPECT_EQ(endReason(), Reason::kDisarmRequested);
  EXPECT_TRUE(step().empty());
  EXPECT_TRUE(core_->arm().accepted());
  EXPECT_EQ(core_->arm().reason, Reason::kAlreadyArmed);
}

TEST_F(ExecutorCoreTest, ReArmedOpenLoopItStartsFromTheLastCommand) {
  ExecutorOptions open_loop;
  open_loop.feedback_timeout_s = 0.0;
  make(open_loop);
  startWalking(25);
  const std::vector<double> last = measured_;
  core_->stop(Reason::kStopRequested);
  step();
  ASSERT_TRUE(core_->arm().accepted());
  EXPECT_EQ(step(), last);
}

TEST_F(ExecutorCoreTest, ASlotIsNeverSentTwice) {
  makeReady();
  EXPECT_EQ(core_->tick(slot_), nullptr);
  EXPECT_EQ(core_->tick(slot_ - 5), nullptr);
  EXPECT_NE(core_->tick(slot_ + 1), nullptr);
}

TEST_F(ExecutorCoreTest, RefusesABehaviorOfAnotherRobot) {
  RobotDescription smaller = shippedRobot();
  smaller.legs.resize(4);
  const Behavior behavior(smaller, Genome(16, 0), BehaviorOptions());
  makeReady();
  EXPECT_EQ(core_->start(behavior, 1).reason, Reason::kBadBehavior);
}

TEST_F(ExecutorCoreTest, AStopMaySayALastWordThatHoldsTheRobotWhereItIs) {
  ExecutorOptions options;
  options.hold_on_stop = true;
  make(options);
  startWalking(30);
  const std::vector<double> last = measured_;
  for (double& angle : measured_) angle += 0.05;
  core_->feedback(driver_.read(measured_));
  core_->stop(Reason::kEStop);
  const std::vector<double> held = step();
  EXPECT_NE(held, last);
  EXPECT_EQ(held, measured_) << "where the robot is, not where it was told to be";
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(step().empty()) << "once";
  core_->stop(Reason::kStopRequested);
  EXPECT_TRUE(step().empty()) << "a robot that was not commanded is not held";
}

TEST_F(ExecutorCoreTest, AnEmergencyStopThatFallsSilentStops) {
  ExecutorOptions options;
  options.e_stop_timeout_s = 0.3;
  make(options);
  step();
  EXPECT_EQ(core_->arm().reason, Reason::kEStopSilent) << "nobody has published e_stop yet";
  core_->heartbeat();
  ASSERT_TRUE(core_->arm().accepted());
  for (int i = 0; i < 100; ++i) {
    core_->heartbeat();
    EXPECT_FALSE(step().empty());
  }
  int sent = 0;
  while (!step().empty() && sent < 100) ++sent;
  EXPECT_NEAR(sent, 10, 1) << "0.3 s of 0.03 s each";
  EXPECT_EQ(mode(), ExecutorMode::kStopped);
  EXPECT_EQ(core_->status().cause.reason, Reason::kEStopSilent);
}

TEST_F(ExecutorCoreTest, EachJointsReadingsAgeByThemselves) {
  startWalking(5);
  JointReadings readings = driver_.read(measured_);
  silent_ = true;
  // All joints but one are read on; that one grows too old.
  int sent = 0;
  for (; sent < 100; ++sent) {
    readings.angles_rad = measured_;
    for (std::size_t j = 0; j < readings.counts.size(); ++j) readings.counts[j] += j == 4 ? 0 : 1;
    core_->feedback(readings);
    if (step().empty()) break;
  }
  EXPECT_NEAR(sent, 17, 1);
  EXPECT_EQ(core_->status().cause.reason, Reason::kFeedbackLost);
  EXPECT_EQ(core_->status().cause.joint, 4);
}

TEST_F(ExecutorCoreTest, WalksWithLegsThatAreReadInTurnAndRarely) {
  makeReady();
  ASSERT_TRUE(core_->start(*behavior_, 1).accepted());
  JointReadings readings = driver_.read(measured_);
  silent_ = true;
  // 20 Hz per leg, each leg at another time, against commands at 33 Hz.
  for (int tick = 0; mode() == ExecutorMode::kWalking && tick < 200; ++tick) {
    for (std::size_t j = 0; j < readings.counts.size(); ++j) {
      if ((tick * 3 + static_cast<int>(j / 3)) % 5 >= 3) continue;
      readings.angles_rad[j] = measured_[j];
      ++readings.counts[j];
    }
    core_->feedback(readings);
    step();
  }
  EXPECT_EQ(mode(), ExecutorMode::kReady)
      << sentence(core_->status().cause, shippedRobot().jointNames());
  EXPECT_EQ(endReason(), Reason::kFinished);
}

TEST_F(ExecutorCoreTest, NoticesFeedbackThatRepeatsItselfWhileCommandsMove) {
  ExecutorOptions options;
  options.max_tracking_error_rad = 0.0;
  make(options);
  makeReady();
  for (int i = 0; i < 200; ++i)
    ASSERT_FALSE(step().empty()) << "standing still is no frozen feedback";
  ASSERT_TRUE(core_->start(*behavior_, 1).accepted());
  blocked_ = true;
  while (mode() == ExecutorMode::kWalking) step();
  EXPECT_EQ(mode(), ExecutorMode::kFault);
  EXPECT_EQ(core_->status().cause.reason, Reason::kFeedbackFrozen);
}

TEST_F(ExecutorCoreTest, ManyServosThatDoNotMoveAtAllAreAFrozenDriver) {
  startWalking(1);
  blocked_ = true;
  while (mode() == ExecutorMode::kWalking) step();
  EXPECT_EQ(core_->status().cause.reason, Reason::kFeedbackFrozen);
}

TEST_F(ExecutorCoreTest, IsNotArmedWhileTwoNodesReportAJoint) {
  JointReadings readings = driver_.read(measured_);
  readings.contested_joint = 3;
  core_->feedback(readings);
  const Cause cause = core_->arm();
  EXPECT_EQ(cause.reason, Reason::kTwoSources);
  EXPECT_NE(sentence(cause, shippedRobot().jointNames()).find("'body_leg_1'"), std::string::npos);
  step();
  EXPECT_TRUE(core_->arm().accepted());
}

TEST_F(ExecutorCoreTest, AJointBelievedDeadNeedNeitherFollowNorBeRead) {
  std::vector<char> dead(neutral_.size(), 0);
  dead[0] = dead[1] = 1;
  core_->tolerate(dead, false);
  JointReadings readings = driver_.read(measured_);
  readings.counts[0] = 0;
  core_->feedback(readings);
  silent_ = true;
  ASSERT_TRUE(core_->arm().accepted());
  const auto play = [&] {
    while (mode() == ExecutorMode::kStandingUp || mode() == ExecutorMode::kWalking) {
      step();
      readings.angles_rad = measured_;
      readings.angles_rad[1] = -1.5;
      for (std::size_t j = 1; j < readings.counts.size(); ++j) ++readings.counts[j];
      core_->feedback(readings);
    }
  };
  play();
  ASSERT_EQ(mode(), ExecutorMode::kReady);
  ASSERT_TRUE(core_->start(*behavior_, 1).accepted());
  play();
  EXPECT_EQ(mode(), ExecutorMode::kReady);
  dead[1] = 0;
  core_->tolerate(dead, false);
  for (int i = 0; i < 100 && mode() == ExecutorMode::kReady; ++i) {
    step();
    for (std::size_t j = 1; j < readings.counts.size(); ++j) ++readings.counts[j];
    core_->feedback(readings);
  }
  EXPECT_EQ(core_->status().cause.reason, Reason::kNotFollowing) << "tolerated no longer";
  EXPECT_EQ(core_->status().cause.joint, 1);
}

TEST_F(ExecutorCoreTest, CommandsThatWereOvertakenCountAsSkipped) {
  startWalking(10);
  const std::uint64_t commands = core_->status().commands;
  core_->overtaken(2);
  EXPECT_EQ(core_->status().commands, commands - 2);
  stepUntil(ExecutorMode::kReady);
  EXPECT_EQ(core_->status().last_end.skipped, 2u);
  EXPECT_EQ(core_->status().skipped, 2u);
}

TEST(ExecutorStatus, EveryReasonIsASentence) {
  for (int reason = 0; reason <= static_cast<int>(Reason::kNoAnswer); ++reason) {
    const std::string text = sentence({static_cast<Reason>(reason)}, {});
    EXPECT_NE(text, "Unknown reason.") << reason;
    EXPECT_EQ(text.back(), '.') << text;
  }
}

}  // namespace
}  // namespace hexapod
