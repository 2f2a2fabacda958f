#include "execution/shared_executor.h"

#include <gtest/gtest.h>

#include <thread>

#include "shipped_robot.h"

namespace hexapod {
namespace {

// A loop thread that ticks as fast as it can and a thread that sends, and what that sent.
class Loop {
 public:
  Loop()
      : executor_(shippedRobot(), BehaviorOptions(), openLoop()),
        loop_([this] { run(); }),
        sender_([this] { send(); }) {}
  ~Loop() {
    running_ = false;
    executor_.stopSending();
    loop_.join();
    sender_.join();
  }

  SharedExecutor& executor() { return executor_; }
  std::uint64_t sent() const { return sent_; }

  void waitForTicks(std::int64_t count) {
    const std::int64_t target = ticks_ + count;
    while (ticks_ < target) std::this_thread::yield();
  }

  void waitFor(ExecutorMode mode) {
    while (executor_.status().mode != mode) std::this_thread::yield();
  }

 private:
  static ExecutorOptions openLoop() {
    ExecutorOptions options;
    options.feedback_timeout_s = 0.0;
    return options;
  }

  void run() {
    for (; running_; ++ticks_) {
      executor_.tick(ticks_, 0);
      std::this_thread::yield();
    }
  }

  void send() {
    const SharedExecutor::Send count = [this](const OutgoingCommand&) { ++sent_; };
    while (executor_.sendNext(count)) {
    }
  }

  SharedExecutor executor_;
  std::atomic<std::uint64_t> sent_{0};
  std::atomic<std::int64_t> ticks_{0};
  std::atomic<bool> running_{true};
  std::thread loop_;
  std::thread sender_;
};

TEST(SharedExecutor, NothingIsSentOnceStopHasReturned) {
  Loop loop;
  for (int i = 0; i < 50; ++i) {
    ASSERT_TRUE(loop.executor().arm().accepted());
    const std::uint64_t before = loop.sent();
    while (loop.sent() < before + 10) std::this_thread::yield();
    loop.executor().stop(Reason::kStopRequested);
    const std::uint64_t stopped = loop.sent();
    loop.waitFor(ExecutorMode::kStopped);
    loop.waitForTicks(3);
    ASSERT_EQ(loop.sent(), stopped);
  }
}

TEST(SharedExecutor, AnswersRequestsFromSeveralThreads) {
  Loop loop;
  ASSERT_TRUE(loop.executor().arm().accepted());
  loop.waitFor(ExecutorMode::kReady);
  const Behavior behavior(shippedRobot(), Genome(24, 1), BehaviorOptions());
  std::atomic<int> accepted{0};
  const auto play = [&] {
    for (int i = 0; i < 50; ++i) {
      if (loop.executor().start(behavior, i).accepted()) ++accepted;
    }
  };
  std::thread first(play);
  std::thread second(play);
  first.join();
  second.join();
  loop.waitFor(ExecutorMode::kReady);
  EXPECT_GE(accepted, 1);
  EXPECT_EQ(loop.executor().status().serial, static_cast<std::uint64_t>(accepted));
  EXPECT_EQ(loop.executor().status().last_end.serial, loop.executor().status().serial);
}

TEST(SharedExecutor, AnEmergencyStopBetweenTwoTicksIsNotMissed) {
  ExecutorOptions options;
  options.feedback_timeout_s = 0.0;
  SharedExecutor executor(shippedRobot(), BehaviorOptions(), options);
  executor.setEStop(true);
  executor.setEStop(false);
  executor.serve();
  EXPECT_EQ(executor.status().mode, ExecutorMode::kStopped);
  EXPECT_EQ(executor.status().cause.reason, Reason::kEStop);
}

TEST(SharedExecutor, WithdrawsARequestTheLoopDoesNotAnswer) {
  SharedExecutor executor(shippedRobot(), BehaviorOptions(), ExecutorOptions());
  EXPECT_EQ(executor.disarm().reason, Reason::kNoAnswer);
  executor.serve();
  EXPECT_EQ(executor.status().mode, ExecutorMode::kDisarmed);
}

// A loop that ticks when told, armed and open loop, with a command on its way to the sender.
class SharedExecutorUnderWay : public testing::Test {
 protected:
  SharedExecutorUnderWay() {
    std::thread caller([this] { EXPECT_TRUE(executor_.arm().accepted()); });
    while (executor_.status().mode != ExecutorMode::kStandingUp) executor_.serve();
    caller.join();
    executor_.tick(slot_++, 0);
  }

  static ExecutorOptions options() {
    ExecutorOptions options;
    options.feedback_timeout_s = 0.0;
    options.hold_on_stop = true;
    return options;
  }

  std::vector<std::int64_t> sent() {
    std::vector<std::int64_t> slots;
    executor_.sendNext([&](const OutgoingCommand& command) { slots.push_back(command.slot); });
    return slots;
  }

  SharedExecutor executor_{shippedRobot(), BehaviorOptions(), options()};
  std::int64_t slot_ = 0;
};

TEST_F(SharedExecutorUnderWay, ACommandUnderWayIsSent) {
  EXPECT_EQ(sent(), std::vector<std::int64_t>{0});
}

TEST_F(SharedExecutorUnderWay, ACommandUnderWayWhenTheStopComesIsNotSentButTheLastWordIs) {
  executor_.stop(Reason::kStopRequested);
  EXPECT_TRUE(sent().empty());
  executor_.tick(slot_++, 0);
  executor_.stop(Reason::kStopRequested);
  EXPECT_EQ(sent(), std::vector<std::int64_t>{1}) << "the word that holds, once";
}

TEST_F(SharedExecutorUnderWay, ACommandUnderWayWhenDisarmedIsNotSent) {
  std::thread caller([this] { EXPECT_TRUE(executor_.disarm().accepted()); });
  while (executor_.status().mode != ExecutorMode::kDisarmed) executor_.serve();
  caller.join();
  EXPECT_TRUE(sent().empty());
}

TEST_F(SharedExecutorUnderWay, OnlyTheNewestCommandIsSentAndTheOthersAreSkipped) {
  executor_.tick(slot_++, 0);
  executor_.tick(slot_++, 0);
  EXPECT_EQ(sent(), std::vector<std::int64_t>{2});
  EXPECT_TRUE(sent().empty()) << "woken for commands that are gone";
  executor_.serve();
  EXPECT_EQ(executor_.status().skipped, 2u);
  EXPECT_EQ(executor_.status().commands, 1u);
}

TEST_F(SharedExecutorUnderWay, TheSendingThreadIsLetGo) {
  executor_.stopSending();
  EXPECT_FALSE(executor_.sendNext([](const OutgoingCommand&) { FAIL(); }));
}

TEST_F(SharedExecutorUnderWay, SaysWhichJointsItTolerates) {
  std::thread caller([this] { EXPECT_TRUE(executor_.tolerate({{3, 4}, true}).accepted()); });
  while (executor_.toleratedJoints().empty()) executor_.serve();
  caller.join();
  EXPECT_EQ(executor_.toleratedJoints(), (std::vector<std::size_t>{3, 4}));
}

}  // namespace
}  // namespace hexapod
