// What the command loop does in a tick, with the real sender, publisher and subscriber: nothing
// that allocates, locks, waits or does I/O. The functions that would are replaced for this program.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pthread.h>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <mutex>
#include <string>
#include <thread>

#include "execution/shipped_robot.h"
#include "ros_interface/common/realtime_loop.h"
#include "ros_interface/executor/sending_thread.h"

namespace {

thread_local bool guarded = false;
thread_local const char* guilty = nullptr;

void note(const char* function) {
  if (guarded && guilty == nullptr) guilty = function;
}

template <typename Function>
Function real(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

void* __libc_malloc(std::size_t size);

void* malloc(std::size_t size) {
  note("malloc");
  return __libc_malloc(size);
}
int pthread_mutex_lock(pthread_mutex_t* mutex) {
  static const auto lock = real<int (*)(pthread_mutex_t*)>("pthread_mutex_lock");
  note("pthread_mutex_lock");
  return lock(mutex);
}
int pthread_cond_signal(pthread_cond_t* condition) {
  static const auto signal = real<int (*)(pthread_cond_t*)>("pthread_cond_signal");
  note("pthread_cond_signal");
  return signal(condition);
}
int clock_nanosleep(clockid_t clock, int flags, const timespec* until, timespec* left) {
  static const auto sleep =
      real<int (*)(clockid_t, int, const timespec*, timespec*)>("clock_nanosleep");
  note("clock_nanosleep");
  return sleep(clock, flags, until, left);
}
ssize_t write(int file, const void* data, std::size_t size) {
  static const auto write_it = real<ssize_t (*)(int, const void*, std::size_t)>("write");
  note("write");
  return write_it(file, data, size);
}
ssize_t send(int socket, const void* data, std::size_t size, int flags) {
  static const auto send_it = real<ssize_t (*)(int, const void*, std::size_t, int)>("send");
  note("send");
  return send_it(socket, data, size, flags);
}

}  // extern "C"

namespace hexapod {
namespace {

// What was done in a thread while it was guarded, or "".
template <typename Work>
std::string doneBy(Work work) {
  guilty = nullptr;
  guarded = true;
  work();
  guarded = false;
  return guilty == nullptr ? "" : guilty;
}

TEST(Guard, SeesAllocationsLocksWaitsAndOutput) {
  EXPECT_EQ(doneBy([] {}), "");
  EXPECT_EQ(doneBy([] { std::vector<double>(100).clear(); }), "malloc");
  std::mutex mutex;
  EXPECT_EQ(doneBy([&] { const std::lock_guard<std::mutex> lock(mutex); }), "pthread_mutex_lock");
  EXPECT_EQ(doneBy([] { sleepUntilSteady(0); }), "clock_nanosleep");
  EXPECT_EQ(doneBy([] { EXPECT_EQ(write(STDOUT_FILENO, "", 0), 0); }), "write");
}

class ExecutorTick : public testing::Test {
 protected:
  // Counts what arrives, as a driver's process would.
  ExecutorTick() {
    subscriber_ = node_.subscribe<sensor_msgs::JointState>(
        "joint_command", 1000,
        boost::function<void(const sensor_msgs::JointState::ConstPtr&)>(
            [this](const sensor_msgs::JointState::ConstPtr&) { ++arrived_; }));
    spinner_.start();
  }

  static ExecutorOptions options() {
    ExecutorOptions options;
    options.ramp_time_s = 0.1;
    return options;
  }

  RealtimeLoop::Callbacks callbacks() {
    RealtimeLoop::Callbacks callbacks;
    callbacks.tick = [this](std::int64_t slot, const ros::Time& stamp) {
      const std::string done = doneBy([&] { executor_.tick(slot, toNs(stamp)); });
      if (!done.empty()) ++guilty_ticks_;
      ++ticks_;
    };
    callbacks.idle = [] {};
    callbacks.may_move_stamps = [] { return true; };
    return callbacks;
  }

  void waitFor(const std::function<bool()>& condition) {
    while (!condition()) {
      executor_.feedback(driver_.read(shippedRobot().neutralPose()));
      std::this_thread::yield();
    }
  }

  ros::NodeHandle node_;
  ros::Subscriber subscriber_;
  ros::AsyncSpinner spinner_{1};
  std::atomic<int> arrived_{0};
  std::atomic<int> ticks_{0};
  std::atomic<int> guilty_ticks_{0};
  WholeRobotDriver driver_;
  SharedExecutor executor_{shippedRobot(), BehaviorOptions(), options()};
};

TEST_F(ExecutorTick, NeitherAllocatesNorLocksNorWaitsNorDoesOutputWithTheRealSender) {
  const auto sender = makeCommandSender(node_, ExecutorNodeOptions(), shippedRobot(),
                                        JointMap::identity(shippedRobot().jointNames()));
  SendingThread sending(executor_, *sender, true);
  const SystemClock clock;
  RealtimeLoop loop({5'000'000, true}, clock, callbacks());
  loop.start();
  waitFor([this] { return executor_.arm().accepted(); });
  waitFor([this] { return executor_.status().mode == ExecutorMode::kReady; });
  Genome quiet(shippedRobot().geneCount(), 0);
  quiet[0] = 1;
  const Behavior behavior(shippedRobot(), quiet, BehaviorOptions());
  ASSERT_TRUE(executor_.start(behavior, 1).accepted());
  waitFor([this] { return arrived_ > 100; });
  executor_.setEStop(true);
  const int ticks = ticks_;
  waitFor([&] { return ticks_ > ticks + 5; });
  loop.stop();
  EXPECT_EQ(executor_.status().mode, ExecutorMode::kStopped);
  EXPECT_EQ(guilty_ticks_, 0) << "of " << ticks_;
}

TEST_F(ExecutorTick, PublishingInTheTickWouldBeSeen) {
  const auto sender = makeCommandSender(node_, ExecutorNodeOptions(), shippedRobot(),
                                        JointMap::identity(shippedRobot().jointNames()));
  EXPECT_NE(doneBy([&] { sender->send(ros::Time(1.0), shippedRobot().neutralPose()); }), "");
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (chdir(HEXAPOD_ROOT) != 0) return 1;
  ros::init(argc, argv, "executor_tick_test");
  ros::start();
  return RUN_ALL_TESTS();
}
