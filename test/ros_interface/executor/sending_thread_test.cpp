#include "ros_interface/executor/sending_thread.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>

#include "execution/shipped_robot.h"
#include "ros_interface/common/clock.h"

namespace hexapod {
namespace {

// A sender that keeps what it sends, and that a test can hold up in the middle of sending.
class RecordingSender : public CommandSender {
 public:
  void send(const ros::Time& stamp, const std::vector<double>& angles_rad) override {
    std::unique_lock<std::mutex> lock(mutex_);
    sending_ = true;
    changed_.notify_all();
    changed_.wait(lock, [this] { return !held_; });
    sending_ = false;
    stamps_.push_back(toNs(stamp));
    angles_rad_ = angles_rad;
    changed_.notify_all();
  }

  void hold(bool held) {
    const std::lock_guard<std::mutex> lock(mutex_);
    held_ = held;
    changed_.notify_all();
  }

  void waitUntilSending() {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return sending_; });
  }

  std::vector<std::int64_t> waitFor(std::size_t count) {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [&] { return stamps_.size() >= count; });
    return stamps_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool held_ = false;
  bool sending_ = false;
  std::vector<std::int64_t> stamps_;
  std::vector<double> angles_rad_;
};

// An open-loop executor that is armed, ticked by the test.
class SendingThreadTest : public testing::Test {
 protected:
  SendingThreadTest() {
    std::thread caller([this] { EXPECT_TRUE(executor_.arm().accepted()); });
    while (executor_.status().mode != ExecutorMode::kStandingUp) executor_.serve();
    caller.join();
  }

  static ExecutorOptions openLoop() {
    ExecutorOptions options;
    options.feedback_timeout_s = 0.0;
    return options;
  }

  void tick() {
    executor_.tick(slot_, 1000 + slot_);
    ++slot_;
  }

  SharedExecutor executor_{shippedRobot(), BehaviorOptions(), openLoop()};
  RecordingSender sender_;
  std::int64_t slot_ = 0;
};

TEST_F(SendingThreadTest, SendsEachCommandWithTheStampOfItsPeriod) {
  SendingThread sending(executor_, sender_, false);
  for (std::size_t i = 1; i <= 20; ++i) {
    tick();
    sender_.waitFor(i);
  }
  const std::vector<std::int64_t> stamps = sender_.waitFor(20);
  for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(stamps[i], 1000 + static_cast<std::int64_t>(i));
}

TEST_F(SendingThreadTest, AStalledPublishDelaysNoTickAndOnlyTheNewestCommandFollows) {
  SendingThread sending(executor_, sender_, false);
  sender_.hold(true);
  tick();
  sender_.waitUntilSending();
  for (int i = 0; i < 10; ++i) tick();  // would hang if the loop waited for the sender
  sender_.hold(false);
  EXPECT_EQ(sender_.waitFor(2), (std::vector<std::int64_t>{1000, 1010}));
  executor_.serve();
  EXPECT_EQ(executor_.status().skipped, 9u);
}

TEST_F(SendingThreadTest, AStopReturnsWhenTheCommandUnderWayIsOutAndNoneFollows) {
  SendingThread sending(executor_, sender_, false);
  sender_.hold(true);
  tick();
  sender_.waitUntilSending();
  tick();
  std::thread stopper([this] { executor_.stop(Reason::kStopRequested); });
  while (executor_.status().mode != ExecutorMode::kStopped) executor_.serve();
  sender_.hold(false);
  stopper.join();
  EXPECT_EQ(sender_.waitFor(1), std::vector<std::int64_t>{1000});
  tick();
  EXPECT_EQ(executor_.status().mode, ExecutorMode::kStopped);
  EXPECT_EQ(sender_.waitFor(1), std::vector<std::int64_t>{1000});
}

}  // namespace
}  // namespace hexapod
