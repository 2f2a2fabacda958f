#include "execution/shared_executor.h"

#include <gtest/gtest.h>

#include <thread>

#include "shipped_robot.h"

namespace hexapod {
namespace {

// A loop thread that ticks as fast as it can, and what it sent.
class Loop {
 public:
  Loop() : executor_(shippedRobot(), BehaviorOptions(), openLoop()), thread_([this] { run(); }) {}
  ~Loop() {
    running_ = false;
    thread_.join();
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
    const SharedExecutor::Send send = [this](const std::vector<double>&) { ++sent_; };
    for (; running_; ++ticks_) {
      executor_.tick(ticks_, send);
      std::this_thread::yield();
    }
  }

  SharedExecutor executor_;
  std::atomic<std::uint64_t> sent_{0};
  std::atomic<std::int64_t> ticks_{0};
  std::atomic<bool> running_{true};
  std::thread thread_;
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
  std::atomic<std::uint64_t> highest{0};
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

}  // namespace
}  // namespace hexapod
