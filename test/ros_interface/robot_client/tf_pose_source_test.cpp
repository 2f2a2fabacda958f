#include "ros_interface/robot_client/tf_pose_source.h"

#include <gtest/gtest.h>

#include "ros_interface/common/conversions.h"
#include "ros_interface/fake_clock.h"
#include "ros_interface/planner/fakes.h"

namespace hexapod {
namespace {

// A robot that stands at kRobot and publishes its pose every 20 ms of steady time, on its own
// clock.
class TfPoseSourceTest : public testing::Test {
 protected:
  TfPoseSourceTest() {
    clock_.on_step = [this] {
      if (clock_.steadyNow_ns() < next_ns_) return;
      next_ns_ = clock_.steadyNow_ns() + 20'000'000;
      robot_time_s_ += 0.02;
      if (publishes_) put("odom", "base_footprint", kRobot, robot_time_s_, false);
    };
  }

  void put(const std::string& parent, const std::string& child, const Pose2& pose, double stamp_s,
           bool is_static) {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = parent;
    transform.header.stamp = ros::Time(stamp_s);
    transform.child_frame_id = child;
    const geometry_msgs::Pose message = toPoseMsg(pose);
    transform.transform.translation.x = message.position.x;
    transform.transform.translation.y = message.position.y;
    transform.transform.rotation = message.orientation;
    buffer_.setTransform(transform, "test", is_static);
  }

  void expectRobot(const PoseReading& reading) {
    ASSERT_TRUE(reading.pose) << reading.problem;
    EXPECT_NEAR(reading.pose->x_m, kRobot.x_m, 1e-9);
    EXPECT_NEAR(reading.pose->y_m, kRobot.y_m, 1e-9);
    EXPECT_NEAR(reading.pose->yaw_rad, kRobot.yaw_rad, 1e-9);
  }
  // What the node does.
  void watch(std::int64_t ns) {
    for (const std::int64_t end_ns = clock_.steadyNow_ns() + ns; clock_.steadyNow_ns() < end_ns;) {
      clock_.pass(kSecond_ns / 50);
      poses_.latest();
    }
  }
  double steady_s() const { return 1e-9 * static_cast<double>(clock_.steadyNow_ns()); }

  static constexpr Pose2 kRobot{1.5, -0.5, 2.0};
  const PoseSource::Stop never_ = [] { return false; };
  PoseOptions options_;
  FakeClock clock_;
  tf2::BufferCore buffer_{ros::Duration(10.0)};
  TfPoseSource poses_{options_, clock_, buffer_};
  bool publishes_ = true;
  double robot_time_s_ = 1000.0;
  std::int64_t next_ns_ = 0;
};

TEST_F(TfPoseSourceTest, ReadsAPoseThatIsStillComing) {
  expectRobot(poses_.robotPose(never_));
  expectRobot(poses_.latest());
}

TEST_F(TfPoseSourceTest, APoseThatStoppedComingIsLostInBoundedTimeWhateverTheClocksDo) {
  for (const double rate : {1.0, 0.0}) {
    for (const double set_s : {0.0, 3600.0, 1e6}) {
      publishes_ = true;
      watch(kSecond_ns / 5);
      expectRobot(poses_.robotPose(never_));
      publishes_ = false;
      clock_.setRate(rate);
      clock_.setRos(set_s);
      const double begin_s = steady_s();
      clock_.pass(9 * kSecond_ns / 10);
      EXPECT_TRUE(poses_.latest().pose) << "short silence is nothing";
      while (poses_.latest().pose) clock_.pass(kSecond_ns / 20);
      EXPECT_FALSE(poses_.robotPose(never_).pose);
      EXPECT_LE(steady_s() - begin_s, 2.2);
    }
  }
}

TEST_F(TfPoseSourceTest, AStampThatChangedWhileNobodyLookedProvesNothing) {
  expectRobot(poses_.robotPose(never_));
  clock_.pass(kSecond_ns / 10);
  publishes_ = false;
  clock_.pass(600 * kSecond_ns);
  EXPECT_FALSE(poses_.latest().pose);
  EXPECT_FALSE(poses_.robotPose(never_).pose);
}

TEST_F(TfPoseSourceTest, ASilenceThatWasWaitedForIsToldSoon) {
  watch(kSecond_ns);
  publishes_ = false;
  watch(2 * kSecond_ns);
  const double begin_s = steady_s();
  EXPECT_FALSE(poses_.robotPose(never_).pose);
  EXPECT_LE(steady_s() - begin_s, 0.25);
}

TEST_F(TfPoseSourceTest, ASilenceThatJustEndedIsNone) {
  watch(kSecond_ns);
  publishes_ = false;
  watch(2 * kSecond_ns);
  publishes_ = true;
  expectRobot(poses_.robotPose(never_));
}

TEST_F(TfPoseSourceTest, AMomentInWhichWeDidNotRunIsNotTheRobotsSilence) {
  watch(kSecond_ns);
  // What came meanwhile is heard afterwards.
  publishes_ = false;
  clock_.pass(3 * kSecond_ns);
  EXPECT_LE(poses_.latest().silent_ns, kSecond_ns / 5);
  publishes_ = true;
  expectRobot(poses_.robotPose(never_));
  // In the midst of a wait, again and again.
  publishes_ = false;
  clock_.pass(3 * kSecond_ns);
  int stalls = 0;
  const auto stall = [&] {
    if (++stalls <= 3) clock_.pass(2 * kSecond_ns);
    publishes_ = stalls > 3;
    return false;
  };
  expectRobot(poses_.robotPose(stall));
  EXPECT_GT(stalls, 3);
  publishes_ = false;
  watch(2 * kSecond_ns);
  EXPECT_GT(poses_.latest().silent_ns, 3 * kSecond_ns / 2);
}

TEST_F(TfPoseSourceTest, AClockThatIsSetLosesNoPose) {
  expectRobot(poses_.robotPose(never_));
  // Ours.
  clock_.setRos(4600.0);
  expectRobot(poses_.robotPose(never_));
  clock_.setRos(10.0);
  expectRobot(poses_.robotPose(never_));
  // The robot's, an hour on and back again: tf refuses what is older than what it has.
  robot_time_s_ += 3600.0;
  clock_.pass(kSecond_ns / 10);
  expectRobot(poses_.robotPose(never_));
  robot_time_s_ -= 3600.0;
  for (int i = 0; i < 30; ++i) {
    clock_.pass(kSecond_ns / 20);
    expectRobot(poses_.latest());
  }
}

TEST_F(TfPoseSourceTest, WaitsUntilTheRobotIsAtRest) {
  expectRobot(poses_.robotPose(never_));
  const ros::Time rest(robot_time_s_ + 0.3);
  expectRobot(poses_.restPose(rest, never_));
  EXPECT_NEAR(robot_time_s_, rest.toSec(), 0.03);
}

TEST_F(TfPoseSourceTest, WaitsNoHourForAStampOfAnotherClock) {
  expectRobot(poses_.robotPose(never_));
  const double begin_s = steady_s();
  expectRobot(poses_.restPose(ros::Time(robot_time_s_ + 3600.0), never_));
  EXPECT_LE(steady_s() - begin_s, 0.7);
  EXPECT_GE(steady_s() - begin_s, options_.pose_settle_s);
}

TEST_F(TfPoseSourceTest, AWaitEndsWhenItIsStopped) {
  publishes_ = false;
  int asked = 0;
  const auto stop = [&] { return ++asked > 3; };
  EXPECT_FALSE(poses_.robotPose(stop).pose);
  EXPECT_LE(steady_s(), 1.1);
}

TEST_F(TfPoseSourceTest, BringsGoalsIntoTheGlobalFrame) {
  put("map", "odom", {2.0, 0.0, M_PI / 2.0}, 0.0, true);
  options_.global_frame = "map";
  const TfPoseSource in_map(options_, clock_, buffer_);
  GoalRequest request = goalAt(1.0, 0.5, 0.25);
  // A quarter turn takes x to y and y to -x: (2 - 0.5, 1).
  const PoseReading goal = in_map.goalPose(request.pose, never_);
  ASSERT_TRUE(goal.pose) << goal.problem;
  EXPECT_NEAR(goal.pose->x_m, 1.5, 1e-9);
  EXPECT_NEAR(goal.pose->y_m, 1.0, 1e-9);
  EXPECT_NEAR(goal.pose->yaw_rad, M_PI / 2.0 + 0.25, 1e-9);
}

TEST_F(TfPoseSourceTest, RefusesGoalsItCannotPlaceWithinItsTimeout) {
  clock_.setRate(0.0);  // simulated time that stands does not lengthen the wait
  GoalRequest request = goalAt(1.0, 0.0, 0.0);
  for (const char* frame : {"nowhere", ""}) {
    request.pose.header.frame_id = frame;
    const double begin_s = steady_s();
    EXPECT_FALSE(poses_.goalPose(request.pose, never_).pose);
    EXPECT_LE(steady_s() - begin_s, options_.tf_timeout_s + 0.01);
  }
  request.pose.header.frame_id = "base_footprint";
  request.pose.header.stamp = ros::Time(9999.0);
  EXPECT_NE(poses_.goalPose(request.pose, never_).problem.find("stamp 0"), std::string::npos);
}

}  // namespace
}  // namespace hexapod
