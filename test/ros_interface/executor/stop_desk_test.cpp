#include "ros_interface/executor/stop_desk.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "execution/shipped_robot.h"

namespace hexapod {
namespace {

// An open-loop executor that is armed. Its command loop runs when the test lets it.
class StopDeskTest : public testing::Test {
 protected:
  StopDeskTest() { EXPECT_TRUE(arm().accepted()); }

  static ExecutorOptions openLoop() {
    ExecutorOptions options;
    options.feedback_timeout_s = 0.0;
    return options;
  }
  Cause arm() {
    std::atomic<bool> done{false};
    Cause cause;
    std::thread caller([&] {
      cause = executor_.arm();
      done = true;
    });
    while (!done) executor_.serve();
    caller.join();
    return cause;
  }

  SharedExecutor executor_{shippedRobot(), BehaviorOptions(), openLoop()};
  StopDesk desk_{executor_};
};

TEST_F(StopDeskTest, AStopNeedsNoCommandLoop) {
  EXPECT_NE(desk_.stop().find("~arm"), std::string::npos);  // comes back though nobody serves
  executor_.serve();
  EXPECT_EQ(executor_.status().mode, ExecutorMode::kStopped);
  EXPECT_EQ(executor_.status().cause.reason, Reason::kStopRequested);
  EXPECT_TRUE(arm().accepted());
}

TEST_F(StopDeskTest, WhilePressedNobodyArmsAndReleasedItStaysStopped) {
  desk_.hear(true);
  EXPECT_EQ(arm().reason, Reason::kEStop);
  desk_.hear(false);
  executor_.serve();
  EXPECT_EQ(executor_.status().mode, ExecutorMode::kStopped);
  EXPECT_EQ(executor_.status().cause.reason, Reason::kEStop);
  EXPECT_TRUE(arm().accepted());
}

TEST_F(StopDeskTest, TellsOnceThatItWasPressed) {
  EXPECT_FALSE(desk_.hear(false));
  EXPECT_TRUE(desk_.hear(true));
  EXPECT_FALSE(desk_.hear(true));
  EXPECT_FALSE(desk_.hear(false));
  EXPECT_TRUE(desk_.hear(true));
}

}  // namespace
}  // namespace hexapod
