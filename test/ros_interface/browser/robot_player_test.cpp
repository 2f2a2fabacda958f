#include "ros_interface/browser/robot_player.h"

#include <gtest/gtest.h>

#include <vector>

#include "../planner/fakes.h"

namespace hexapod {
namespace {

class RobotPlayerTest : public testing::Test {
 protected:
  RobotPlayerTest() {
    entry_.id = 7;
    entry_.end_pose = {0.3, 0.1, 0.5};
  }

  void tell(const RobotPlayer::Report& report) {
    const std::lock_guard<std::mutex> lock(mutex_);
    reports_.push_back(report);
  }
  std::vector<RobotPlayer::Report> reports() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return reports_;
  }
  void awaitEnd() const {
    while (player_.isPlaying()) std::this_thread::yield();
  }

  Entry entry_;
  FakePoseSource poses_;
  FakePlayer executor_{poses_};
  mutable std::mutex mutex_;
  std::vector<RobotPlayer::Report> reports_;
  RobotPlayer player_{executor_, poses_, ros::Duration(0.1),
                      [this](const RobotPlayer::Report& report) { tell(report); }};
};

TEST_F(RobotPlayerTest, TellsWhereTheRobotStoodAndWhatItReached) {
  poses_.set({Pose2{1.0, 2.0, 0.0}, ""});
  EXPECT_EQ(player_.play("run", entry_), "");
  awaitEnd();
  ASSERT_EQ(reports().size(), 2u);  // begun, ended
  EXPECT_FALSE(reports()[0].reached);
  const RobotPlayer::Report report = reports()[1];
  EXPECT_EQ(report.problem, "");
  EXPECT_NEAR(report.start->x_m, 1.0, 1e-12);
  EXPECT_NEAR(report.reached->x_m, 1.3, 1e-12);
  EXPECT_NEAR(report.reached->y_m, 2.1, 1e-12);
}

TEST_F(RobotPlayerTest, PlaysOneAtATime) {
  executor_.held = true;
  EXPECT_EQ(player_.play("run", entry_), "");
  EXPECT_NE(player_.play("run", entry_).find("still being played"), std::string::npos);
  executor_.held = false;
  awaitEnd();
  EXPECT_EQ(executor_.begun, 1);
  EXPECT_EQ(player_.play("run", entry_), "");
  awaitEnd();
  EXPECT_EQ(executor_.begun, 2);
}

TEST_F(RobotPlayerTest, PlaysNothingOnARobotThatIsNotReadyOrNotFound) {
  executor_.becomeUnready("The executor is disarmed.");
  EXPECT_EQ(player_.play("run", entry_), "The executor is disarmed.");
  executor_.becomeUnready("");
  poses_.set({std::nullopt, "The robot's pose is lost."});
  EXPECT_EQ(player_.play("run", entry_), "");
  awaitEnd();
  EXPECT_EQ(executor_.begun, 0);
  EXPECT_EQ(reports().back().problem, "The robot's pose is lost.");
}

TEST_F(RobotPlayerTest, PlaysNoEntryThatFellInItsValidation) {
  entry_.execution = Execution{{0.3, 0.1, 0.5}, 0.0, 0.0, 8, 1};
  EXPECT_NE(player_.play("run", entry_), "");
  EXPECT_FALSE(player_.isPlaying());
}

TEST_F(RobotPlayerTest, TellsWhyABehaviourWasNotPlayedToItsEnd) {
  executor_.outcome = [] {
    return BehaviorPlayer::Result{BehaviorPlayer::End::kFault, "A joint does not follow.", {}, 0};
  };
  EXPECT_EQ(player_.play("run", entry_), "");
  awaitEnd();
  EXPECT_EQ(reports().back().problem, "A joint does not follow.");
  EXPECT_FALSE(reports().back().reached);
}

}  // namespace
}  // namespace hexapod
