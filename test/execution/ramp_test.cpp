#include "execution/ramp.h"

#include <gtest/gtest.h>

#include "shipped_robot.h"

namespace hexapod {
namespace {

TEST(Ramp, StartsAndEndsExactlyAndHoldsBefore) {
  Ramp ramp(shippedRobot());
  std::vector<double> from = shippedRobot().neutralPose();
  for (double& angle : from) angle += 0.3;
  ramp.plan(from, shippedRobot().neutralPose(), 0.09, 0.6, kPeriod_s);
  EXPECT_EQ(ramp.length(), 3 + 20);
  std::vector<double> pose = from;
  for (int k : {0, 1, 3}) {
    ramp.pose(k, pose);
    EXPECT_EQ(pose, from) << k;
  }
  // Half way: 3/4 - 2/8 = 1/2.
  ramp.pose(13, pose);
  EXPECT_NEAR(pose[0], 0.15, 1e-12);
  for (int k : {23, 24, 1000}) {
    ramp.pose(k, pose);
    EXPECT_EQ(pose, shippedRobot().neutralPose()) << k;
  }
}

TEST(Ramp, TakesLongerRatherThanExceedAVelocityLimit) {
  Ramp ramp(shippedRobot());
  std::vector<double> from = shippedRobot().neutralPose();
  from[5] = 1.5;
  ramp.plan(from, shippedRobot().neutralPose(), 0.0, 0.1, kPeriod_s);
  std::vector<double> before = from;
  std::vector<double> pose = from;
  for (int k = 1; k <= ramp.length(); ++k) {
    ramp.pose(k, pose);
    EXPECT_LE(largestStep(pose, before), 6.28 * kPeriod_s * (1.0 + 1e-9));
    before = pose;
  }
  EXPECT_EQ(pose, shippedRobot().neutralPose());
}

}  // namespace
}  // namespace hexapod
