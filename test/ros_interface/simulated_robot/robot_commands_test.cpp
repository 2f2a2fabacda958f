#include "ros_interface/simulated_robot/robot_commands.h"

#include <gtest/gtest.h>

#include <cmath>

#include "execution/shipped_robot.h"
#include "ros_interface/common/clock.h"

namespace hexapod {
namespace {

constexpr std::int64_t kNow = 1'700'000'000 * kSecond_ns;

// Commands that act 60 ms after their stamp, on a robot whose last step began at kNow.
class RobotCommandsTest : public testing::Test {
 protected:
  RobotCommandsTest() { commands_.due(kNow); }

  static sensor_msgs::JointState command(std::int64_t stamp_ns, double offset_rad = 0.0) {
    sensor_msgs::JointState command;
    command.header.stamp = timeFromNs(stamp_ns);
    command.name = shippedRobot().jointNames();
    command.position = shippedRobot().neutralPose();
    for (double& position_rad : command.position) position_rad += offset_rad;
    return command;
  }
  void expectRefused(const sensor_msgs::JointState& command, const std::string& because) {
    const std::uint64_t before = commands_.counts().refused;
    EXPECT_FALSE(commands_.take(command));
    EXPECT_EQ(commands_.counts().refused, before + 1);
    EXPECT_NE(commands_.problem().find(because), std::string::npos) << commands_.problem();
    EXPECT_EQ(commands_.due(kNow + kSecond_ns), nullptr) << "physics sees nothing of it";
  }

  RobotCommands commands_{shippedRobot(), 60 * kMillisecond_ns};
};

TEST_F(RobotCommandsTest, ACommandActsALatencyAfterItsStamp) {
  commands_.take(command(kNow, 0.01));
  EXPECT_EQ(commands_.due(kNow + 59 * kMillisecond_ns), nullptr);
  const std::vector<double>* targets = commands_.due(kNow + 60 * kMillisecond_ns);
  ASSERT_NE(targets, nullptr);
  EXPECT_EQ(*targets, command(0, 0.01).position);
  EXPECT_EQ(commands_.due(kNow + 75 * kMillisecond_ns), nullptr) << "it goes on acting";
}

TEST_F(RobotCommandsTest, NamesMayComeInAnyOrder) {
  sensor_msgs::JointState turned = command(kNow);
  std::reverse(turned.name.begin(), turned.name.end());
  std::reverse(turned.position.begin(), turned.position.end());
  commands_.take(turned);
  EXPECT_EQ(*commands_.due(kNow + 60 * kMillisecond_ns), shippedRobot().neutralPose());
}

TEST_F(RobotCommandsTest, PhysicsSeesOnlyCommandsThatAreWholeFiniteAndWithinLimits) {
  sensor_msgs::JointState wrong = command(kNow);
  wrong.position[4] = NAN;
  expectRefused(wrong, "not a finite number");
  wrong = command(kNow);
  wrong.name[2] = "antenna";
  expectRefused(wrong, "'antenna'");
  wrong = command(kNow);
  wrong.position.pop_back();
  expectRefused(wrong, "18 names and 17 positions");
  wrong = command(kNow);
  wrong.name[1] = wrong.name[0];
  expectRefused(wrong, "twice");
  wrong = command(kNow);
  wrong.position[0] = shippedRobot().joints()[0]->upper_rad + 0.01;
  expectRefused(wrong, "The target of joint '" + wrong.name[0] + "'");
  EXPECT_EQ(commands_.counts().received, 5u);
}

TEST_F(RobotCommandsTest, CountsWhatCameLateOrFromAnotherClock) {
  commands_.take(command(kNow - 61 * kMillisecond_ns));
  EXPECT_EQ(commands_.counts().late, 1u);
  commands_.take(command(kNow + 3600 * kSecond_ns));
  EXPECT_EQ(commands_.counts().foreign, 1u);
  EXPECT_NE(commands_.due(kNow + 15 * kMillisecond_ns), nullptr) << "both act from the next step";
}

TEST_F(RobotCommandsTest, ExpectsTheNextCommandOfALiveStreamOnly) {
  EXPECT_FALSE(commands_.expects(kNow + 60 * kMillisecond_ns)) << "nobody sends";
  commands_.take(command(kNow));
  EXPECT_FALSE(commands_.expects(kNow + 60 * kMillisecond_ns)) << "one command is no stream";
  commands_.take(command(kNow + 30 * kMillisecond_ns));
  EXPECT_FALSE(commands_.expects(kNow + 59 * kMillisecond_ns));
  EXPECT_TRUE(commands_.expects(kNow + 60 * kMillisecond_ns));
  commands_.giveUp();
  EXPECT_FALSE(commands_.expects(kNow + 60 * kMillisecond_ns));
  commands_.take(command(kNow + 500 * kMillisecond_ns));
  EXPECT_FALSE(commands_.expects(kNow + kSecond_ns)) << "a pause ends a stream";
}

TEST_F(RobotCommandsTest, DisturbedCommandsActLaterAndSomeAreLost) {
  commands_.disturb(45 * kMillisecond_ns, 0.0);
  commands_.take(command(kNow));
  EXPECT_EQ(commands_.due(kNow + 104 * kMillisecond_ns), nullptr);
  EXPECT_NE(commands_.due(kNow + 105 * kMillisecond_ns), nullptr);
  commands_.disturb(0, 0.25);
  for (int i = 0; i < 400; ++i) commands_.take(command(0));
  // Four standard deviations of a binomial distribution: 4 * sqrt(400 * 0.25 * 0.75) = 35.
  EXPECT_NEAR(static_cast<double>(commands_.counts().lost), 100.0, 35.0);
}

TEST_F(RobotCommandsTest, AClearedScheduleActsNoMore) {
  commands_.take(command(kNow));
  commands_.clear();
  EXPECT_EQ(commands_.due(kNow + kSecond_ns), nullptr);
}

}  // namespace
}  // namespace hexapod
