#include "ros_interface/planner/twist_walk.h"

#include <gtest/gtest.h>

#include <cmath>

#include "planning/arc_repertoire.h"

namespace hexapod {
namespace {

// One metre ahead and one radian at most: no twist below is cut short.
const Planner kFar(repertoireOf({entryTo({1.0, 0.0, 0.0}), entryTo({0.2, 0.2, 1.0})}),
                   PlannerOptions());

TEST(PoseAfter, IsWhereManySmallStepsLead) {
  for (const Twist& twist : {Twist{0.2, 0.0, 0.0}, Twist{0.1, 0.05, 0.2}, Twist{-0.1, 0.0, -0.2},
                             Twist{0.0, 0.0, 0.2}}) {
    Pose2 pose;
    constexpr int kSteps = 100000;
    constexpr double kStep_s = 3.9 / kSteps;
    for (int i = 0; i < kSteps; ++i) {
      pose = pose * Pose2{twist.x_m_per_s * kStep_s, twist.y_m_per_s * kStep_s,
                          twist.yaw_rad_per_s * kStep_s};
    }
    const Pose2 end = poseAfter(twist, 3.9, kFar);
    EXPECT_NEAR(end.x_m, pose.x_m, 1e-4);
    EXPECT_NEAR(end.y_m, pose.y_m, 1e-4);
    EXPECT_NEAR(end.yaw_rad, pose.yaw_rad, 1e-9);
  }
}

TEST(PoseAfter, FollowsTheArcOnlyAsFarAsTheRepertoireReaches) {
  // 4 m in 4 s of which the farthest entry covers 1 m: a quarter of the time.
  EXPECT_NEAR(poseAfter({1.0, 0.0, 0.0}, 4.0, kFar).x_m, 1.0, 1e-9);
  // Six radians, which would be a small turn to the other side.
  EXPECT_NEAR(poseAfter({0.0, 0.0, 1.5}, 4.0, kFar).yaw_rad, 1.0, 1e-9);
}

TEST(NearestStep, IsTheNearestOfAllEntries) {
  const Repertoire repertoire = arcRepertoire(200, 3);
  const Planner planner(repertoire, PlannerOptions());
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const Pose2 wanted = randomArcEnd(random);
    double least = 1e9;
    for (const Entry& entry : repertoire.entries) {
      least = std::min(least, distance(entry.expectedPose(), wanted) +
                                  0.3 * headingDistance(entry.expectedPose(), wanted));
    }
    const auto step = planner.nearestStep(wanted);
    ASSERT_TRUE(step);
    EXPECT_NEAR(distance(step->world_from_end, wanted) +
                    0.3 * headingDistance(step->world_from_end, wanted),
                least, 1e-12);
  }
  EXPECT_FALSE(Planner(Repertoire(), PlannerOptions()).nearestStep(Pose2()));
}

}  // namespace
}  // namespace hexapod
