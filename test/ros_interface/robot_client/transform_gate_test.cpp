#include "ros_interface/robot_client/transform_gate.h"

#include <gtest/gtest.h>

#include <limits>

namespace hexapod {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

class TransformGateTest : public testing::Test {
 protected:
  std::string problemOf(const std::string& frame, const TransformGate::Source& source,
                        std::uint32_t stamp_s = 100) {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = "odom";
    transform.header.stamp.sec = stamp_s;
    transform.child_frame_id = frame;
    return gate_.whyRefused(transform, source);
  }

  TransformGate gate_;
};

TEST_F(TransformGateTest, AFrameThatANodeMovesIsNotMovedByAnotherWhileItIsHeard) {
  EXPECT_EQ(problemOf("base", {"/robot", false, 0}), "");
  const std::string problem = problemOf("base", {"/stray", false, kSecond});
  EXPECT_NE(problem.find("/stray"), std::string::npos) << problem;
  EXPECT_NE(problem.find("/robot moves"), std::string::npos) << problem;
  EXPECT_EQ(problemOf("base", {"/robot", false, 2 * kSecond}), "");
  EXPECT_NE(problemOf("base", {"/stray", false, 4 * kSecond}), "");
  EXPECT_EQ(problemOf("base", {"/stray", false, 4 * kSecond + 1}), "") << "the robot is gone";
  EXPECT_NE(problemOf("base", {"/robot", false, 5 * kSecond}), "");
  EXPECT_EQ(problemOf("lidar", {"/stray", false, 5 * kSecond}), "") << "another frame";
}

TEST_F(TransformGateTest, AMovingFrameNeverBecomesStatic) {
  EXPECT_EQ(problemOf("base", {"/robot", false, 0}), "");
  EXPECT_NE(problemOf("base", {"/stray", true, 100 * kSecond}), "");
  EXPECT_NE(problemOf("base", {"/robot", true, 100 * kSecond}), "");
}

TEST_F(TransformGateTest, AStaticFrameMayBeSetAgainByAnybody) {
  EXPECT_EQ(problemOf("lidar", {"/mount", true, 0}), "");
  EXPECT_EQ(problemOf("lidar", {"/mount_2", true, kSecond}), "");
}

TEST_F(TransformGateTest, RefusesStampsThatTf2CannotAddTo) {
  constexpr auto kLast = static_cast<std::uint32_t>(std::numeric_limits<std::int32_t>::max());
  EXPECT_EQ(problemOf("base", {"/robot", false, 0}, kLast), "");
  EXPECT_NE(problemOf("base", {"/robot", false, 0}, kLast + 1), "");
}

TEST_F(TransformGateTest, RefusesEndlessNamesAndFramesWithoutEnd) {
  EXPECT_EQ(problemOf(std::string(TransformGate::kLongestName, 'x'), {"/robot", false, 0}), "");
  const std::string problem =
      problemOf(std::string(TransformGate::kLongestName + 1, 'x'), {"/robot", false, 0});
  EXPECT_NE(problem, "");
  EXPECT_LT(problem.size(), 150u) << "the name is not repeated";
  for (std::size_t i = 1; i < TransformGate::kMostFrames; ++i) {
    ASSERT_EQ(problemOf("frame_" + std::to_string(i), {"/robot", false, 0}), "");
  }
  EXPECT_NE(problemOf("one_more", {"/robot", false, 0}), "");
  EXPECT_EQ(problemOf("frame_1", {"/robot", false, 0}), "");
}

}  // namespace
}  // namespace hexapod
