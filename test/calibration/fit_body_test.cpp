#include "calibration/fit_body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "made_trials.h"

namespace hexapod {
namespace {

Physics tired() {
  Physics body;
  body.friction_scale = 0.8;
  body.servo_gain_scale = 0.85;
  body.mass_scale = 1.1;
  return body;
}

// What is easy is found soon.
FitOptions brief() {
  FitOptions options;
  options.pairs = 20;
  options.rounds = 10;
  return options;
}

FittedBody fitTo(const std::vector<Trial>& trials, const FitOptions& options = brief(),
                 int threads = 1) {
  return fitBody(TrialChain(imaginationOf(threads), Physics(), seenOf(trials)), options);
}

TEST(TrialChain, ImaginesTheRightBodyExactly) {
  const std::vector<Trial> trials = trialsOf(tired(), 6);
  ASSERT_EQ(trials.size(), 6u);
  const TrialChain chain(imaginationOf(), Physics(), seenOf(trials));
  const auto misses = chain.misses({BodyVector::Zero(), parametersOf(tired(), Physics())});
  EXPECT_GT(medianOf(misses[0]).position_m, 0.005);
  for (const Eigen::Vector3d& miss : misses[1]) EXPECT_LT(miss.norm(), 1e-4);
}

TEST(FitBody, FindsTheBodyThatWalked) {
  const std::vector<Trial> trials = trialsOf(tired(), 8);
  FitOptions options;
  options.rounds = 20;
  options.pairs = 40;
  const FittedBody fitted = fitTo(trials, options);
  const TrialChain chain(imaginationOf(), Physics(), seenOf(trials));
  const double before_m = medianOf(chain.misses({BodyVector::Zero()}).front()).position_m;
  EXPECT_LT(medianOf(fitted.misses).position_m, 0.2 * before_m);
  EXPECT_NEAR(std::exp(fitted.mean[kServoGain]), 0.85, 0.03);
  EXPECT_EQ(fitted.left_out, 0);
  // Within four of its own deviations.
  const BodyVector truth = parametersOf(tired(), Physics());
  for (int i = 0; i < kBodyParameters; ++i) {
    EXPECT_LT(std::abs(fitted.mean[i] - truth[i]), 4.0 * std::sqrt(fitted.covariance(i, i))) << i;
    EXPECT_LT(fitted.covariance(i, i), std::pow(possibleDeviations()[i], 2) + 1e-12);
  }
}

TEST(FitBody, LeavesARobotAloneThatIsAsItsFilesSay) {
  const FittedBody fitted = fitTo(trialsOf(Physics(), 6));
  EXPECT_LT(fitted.mean.norm(), 0.03);
}

TEST(FitBody, LetsOneTrialThatNobodyExplainsDecideLittle) {
  std::vector<Trial> trials = trialsOf(tired(), 8);
  trials[3].seen.world_from_after.x_m += 0.5;
  const FittedBody fitted = fitTo(trials);
  EXPECT_EQ(fitted.left_out, 1);
  EXPECT_NEAR(std::exp(fitted.mean[kServoGain]), 0.85, 0.06);
}

TEST(FitBody, IsTheSameForAnyNumberOfThreads) {
  FitOptions options;
  options.pairs = 6;
  options.rounds = 2;
  const std::vector<Trial> trials = trialsOf(tired(), 3);
  EXPECT_EQ(fitTo(trials, options, 1).mean, fitTo(trials, options, 2).mean);
}

TEST(FitBody, NeedsSomethingToFitTo) { EXPECT_THROW(fitTo({}), std::invalid_argument); }

TEST(MedianMiss, CountsWhatIsNotKnownAsFar) {
  // Distances 3, 5 and 13; headings 0.1, 0.2 and 0.3.
  EXPECT_DOUBLE_EQ(medianOf({{3, 0, -0.3}, {3, -4, 0.1}, {5, 12, 0.2}}).position_m, 5.0);
  EXPECT_DOUBLE_EQ(medianOf({{3, 0, -0.3}, {3, -4, 0.1}, {5, 12, 0.2}}).heading_rad, 0.2);
  EXPECT_DOUBLE_EQ(medianOf({{3, 4, 0}, {NAN, 0, 0}, {1, 0, 0}}).position_m, 5.0);
}

}  // namespace
}  // namespace hexapod
