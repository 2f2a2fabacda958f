#include "gait/outcome.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "common/random.h"

namespace hexapod {
namespace {

TEST(Outcome, IsNotWalkedUntilSaidSo) {
  EXPECT_FALSE(Outcome().walked());
  EXPECT_EQ(toString(Verdict::kWalked), "walked");
  EXPECT_EQ(toString(Verdict::kFell), "fell");
  EXPECT_EQ(toString(Verdict::kSelfCollided), "self-collided");
  EXPECT_EQ(toString(Verdict::kDiverged), "diverged");
}

TEST(Outcome, CoordinatesAreRoundedToTenMicrometresAndTenMicroradians) {
  const Outcome outcome = walkedTo({0.123456, -0.200004, 1.000006});
  ASSERT_TRUE(outcome.walked());
  EXPECT_DOUBLE_EQ(outcome.end_pose.x_m, 0.12346);
  EXPECT_DOUBLE_EQ(outcome.end_pose.y_m, -0.2);
  EXPECT_DOUBLE_EQ(outcome.end_pose.yaw_rad, 1.00001);
}

TEST(Outcome, OrientationErrorIsThatOfTheArc) {
  // The arc to (1, 1) arrives at 90 degrees; the robot looks at 80.
  const Outcome outcome = walkedTo({1.0, 1.0, 80.0 * M_PI / 180.0});
  EXPECT_NEAR(outcome.cost, 10.0 * M_PI / 180.0, 2e-5);
  EXPECT_EQ(walkedTo({0.5, 0.0, 0.0}).cost, 0.0);
}

TEST(Outcome, MirroredPosesTieExactly) {
  Random random(7);
  for (int i = 0; i < 1000; ++i) {
    const Pose2 pose{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-3, 3)};
    const Outcome outcome = walkedTo(pose);
    // Left-right, fore-aft and both (half a turn about z).
    for (const Pose2& twin :
         {Pose2{pose.x_m, -pose.y_m, -pose.yaw_rad}, Pose2{-pose.x_m, pose.y_m, -pose.yaw_rad},
          Pose2{-pose.x_m, -pose.y_m, pose.yaw_rad}}) {
      EXPECT_EQ(walkedTo(twin).cost, outcome.cost);
      EXPECT_EQ(std::abs(walkedTo(twin).end_pose.x_m), std::abs(outcome.end_pose.x_m));
      EXPECT_EQ(std::abs(walkedTo(twin).end_pose.yaw_rad), std::abs(outcome.end_pose.yaw_rad));
    }
  }
}

TEST(Outcome, HasNoNegativeZero) {
  const Pose2 pose = walkedTo({-1e-9, -0.0, -1e-9}).end_pose;
  EXPECT_FALSE(std::signbit(pose.x_m));
  EXPECT_FALSE(std::signbit(pose.y_m));
  EXPECT_FALSE(std::signbit(pose.yaw_rad));
}

TEST(Outcome, PoseThatIsNotFiniteIsDiverged) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  for (const Pose2& pose : {Pose2{nan, 0, 0}, Pose2{0, inf, 0}, Pose2{0, 0, -inf}, Pose2{0, 0, nan},
                            Pose2{1e305, 0, 0}}) {
    EXPECT_EQ(walkedTo(pose).verdict, Verdict::kDiverged);
  }
}

}  // namespace
}  // namespace hexapod
