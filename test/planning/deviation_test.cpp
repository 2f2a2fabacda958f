#include "planning/deviation.h"

#include <gtest/gtest.h>

#include <limits>

#include "arc_repertoire.h"

namespace hexapod {
namespace {

TEST(Deviation, AppliesScaleDirectionAndTurn) {
  const Deviation deviation = {2.0, M_PI / 2, 0.5, 0.1};
  const Pose2 end = deviation.apply({0.3, 0.1, 0.4});
  EXPECT_NEAR(end.x_m, -0.2, 1e-12);
  EXPECT_NEAR(end.y_m, 0.6, 1e-12);
  EXPECT_NEAR(end.yaw_rad, 0.5 * 0.4 + 0.1, 1e-12);
}

TEST(DeviationEstimator, KnowsOfNoneAtFirst) {
  EXPECT_EQ(DeviationEstimator().deviation(), Deviation{});
}

TEST(DeviationEstimator, TakesNoiseForNoDeviation) {
  Random random(1);
  DeviationEstimator estimator;
  for (int i = 0; i < 100; ++i) {
    const Pose2 expected = randomArcEnd(random);
    estimator.observe(expected,
                      {expected.x_m + 0.004 * normal(random), expected.y_m + 0.004 * normal(random),
                       wrapAngle(expected.yaw_rad + 0.01 * normal(random))});
    EXPECT_EQ(estimator.deviation(), Deviation{});
  }
}

TEST(DeviationEstimator, FindsADeviationWithinTenBehaviours) {
  Random random(2);
  const Deviation truth = {1.28, -0.15, 0.8, 0.12};
  DeviationEstimator estimator;
  for (int i = 0; i < 10; ++i) {
    const Pose2 expected = randomArcEnd(random);
    estimator.observe(expected, truth.apply(expected));
  }
  const Deviation found = estimator.deviation();
  EXPECT_NEAR(found.scale, truth.scale, 0.04);
  EXPECT_NEAR(found.direction_rad, truth.direction_rad, 0.03);
  EXPECT_NEAR(found.turn_scale, truth.turn_scale, 0.04);
  EXPECT_NEAR(found.turn_rad, truth.turn_rad, 0.03);
}

TEST(DeviationEstimator, ForgetsADeviationThatIsOver) {
  Random random(3);
  DeviationEstimator estimator;
  for (int i = 0; i < 60; ++i) {
    const Pose2 expected = randomArcEnd(random);
    estimator.observe(expected, i < 20 ? Deviation{1.4, 0.1, 1.0, 0.1}.apply(expected) : expected);
  }
  EXPECT_EQ(estimator.deviation(), Deviation{});
}

TEST(DeviationEstimator, IgnoresAccidents) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  DeviationEstimator estimator;
  estimator.observe({0.5, 0.0, 0.0}, {nan, 0.0, 0.0});
  estimator.observe({nan, 0.0, 0.0}, {0.5, 0.0, 0.0});
  estimator.observe({0.5, 0.0, 0.0}, {0.0, 0.0, 0.0});
  estimator.observe({0.5, 0.0, 0.0}, {5.0, 0.0, 0.0});
  estimator.observe({0.5, 0.0, 0.0}, {0.5, 0.0, 2.0});
  EXPECT_EQ(estimator.deviation(), Deviation{});
}

TEST(DeviationEstimator, StaysWithinItsLimits) {
  DeviationEstimator estimator;
  for (int i = 0; i < 100; ++i) estimator.observe({0.3, 0.0, 0.1}, {-0.7, 0.1, 0.8});
  const Deviation found = estimator.deviation();
  EXPECT_LE(found.scale, 2.0);
  EXPECT_LE(std::abs(found.direction_rad), M_PI / 6 + 1e-9);
  EXPECT_LE(std::abs(found.turn_rad), M_PI / 6 + 1e-9);
  EXPECT_LE(found.turn_scale, 2.0);
}

}  // namespace
}  // namespace hexapod
