#include "self_model/body_belief.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "walked_body.h"

namespace hexapod {
namespace {

std::shared_ptr<const Imagination> imagination(int threads = 1) {
  return std::make_shared<Imagination>(shippedRobot(), BehaviorOptions(), Engine::kReduced,
                                       threads);
}

std::string believed(const BodyBelief& belief) {
  return describeLegs(shippedRobot(), belief.bodies().front().legs);
}

std::size_t legNumber(const std::string& name) {
  const RobotDescription robot = shippedRobot();
  std::size_t leg = 0;
  while (robot.legs.at(leg).name != name) ++leg;
  return leg;
}

// Believes what the body does, gait after gait.
void watch(WalkedBody& body, int behaviors, BodyBelief& belief, double noise_m = 0.0) {
  const std::vector<Genome> gaits = walkingGaits();
  for (int i = 0; i < behaviors; ++i) belief.observe(body.walk(gaits[i % gaits.size()], noise_m));
}

TEST(BodyBelief, BeginsWithAnIntactRobot) {
  const BodyBelief belief(imagination(), Physics(), BeliefOptions());
  EXPECT_EQ(believed(belief), "intact");
  EXPECT_GT(belief.probability(0), 0.7);
  EXPECT_EQ(belief.bodies().size(), 1u + 24u + 6u * 4u);
}

TEST(BodyBelief, BeginsWithTheBodyThatWasLearnedFor) {
  Physics learned;
  learned.legs = legStatesFromText(shippedRobot(), "left_middle: locked");
  learned.friction_scale = 0.8;
  BodyBelief belief(imagination(), learned, BeliefOptions());
  EXPECT_EQ(believed(belief), "left_middle: locked");
  EXPECT_GT(belief.probability(0), 0.7);
  EXPECT_EQ(belief.physicsOf(belief.bodies().front()).friction_scale, 0.8);
  // As many as ever: an intact robot is one of the others.
  EXPECT_EQ(belief.bodies().size(), 1u + 24u + 6u * 4u);
  Physics repaired;
  repaired.friction_scale = 0.8;
  WalkedBody body("", repaired);
  watch(body, 2, belief);
  EXPECT_EQ(believed(belief), "intact");
}

TEST(BodyBelief, NamesALiftedLegAfterOneBehaviour) {
  for (const std::string leg : {"left_rear", "left_middle", "right_front"}) {
    WalkedBody body(leg + ": lifted");
    BodyBelief belief(imagination(), Physics(), BeliefOptions());
    watch(body, 1, belief);
    EXPECT_EQ(believed(belief).find(leg), 0u) << believed(belief);
    watch(body, 2, belief);
    EXPECT_EQ(believed(belief), leg + ": lifted");
    EXPECT_GT(belief.probability(0), 0.9);
  }
}

TEST(BodyBelief, NamesALimpAndAMissingLeg) {
  for (const std::string damage : {"right_middle: limp", "left_front: missing"}) {
    WalkedBody body(damage);
    BodyBelief belief(imagination(), Physics(), BeliefOptions());
    watch(body, 4, belief);
    EXPECT_EQ(believed(belief), damage);
  }
}

TEST(BodyBelief, NamesTwoLegs) {
  WalkedBody body("left_middle: lifted, right_middle: lifted");
  BodyBelief belief(imagination(), Physics(), BeliefOptions());
  watch(body, 4, belief);
  EXPECT_EQ(believed(belief), "left_middle: lifted, right_middle: lifted");
}

TEST(BodyBelief, NoticesALegThatBreaksAndOneThatIsRepaired) {
  WalkedBody body("");
  BodyBelief belief(imagination(), Physics(), BeliefOptions());
  watch(body, 4, belief);
  EXPECT_EQ(believed(belief), "intact");
  body.become("left_middle: lifted");
  watch(body, 3, belief);
  EXPECT_EQ(believed(belief), "left_middle: lifted");
  body.become("");
  watch(body, 3, belief);
  EXPECT_EQ(believed(belief), "intact");
}

TEST(BodyBelief, TakesNoiseForNoDamage) {
  BeliefOptions options;
  options.measurement_noise_m = 0.01;
  options.measurement_noise_rad = 0.01 / 0.3;
  WalkedBody body("");
  BodyBelief belief(imagination(), Physics(), options);
  for (int i = 0; i < 6; ++i) {
    watch(body, 1, belief, 0.01);
    EXPECT_EQ(believed(belief), "intact");
  }
}

TEST(BodyBelief, FindsWhatDiffersByDegrees) {
  Physics truth;
  truth.servo_gain_scale = 0.7;
  truth.slope_x_rad = 0.03;
  WalkedBody body("", truth);
  BodyBelief belief(imagination(), Physics(), BeliefOptions());
  watch(body, 8, belief);
  EXPECT_EQ(believed(belief), "intact");
  const BelievedBody& best = belief.bodies().front();
  const Physics found = belief.physicsOf(best);
  EXPECT_NEAR(found.servo_gain_scale, 0.7, 0.1);
  EXPECT_NEAR(found.slope_x_rad, 0.03, 0.01);
  EXPECT_NEAR(found.slope_y_rad, 0.0, 0.01);
  EXPECT_LT(best.misfit, 11.0);
  EXPECT_LT(best.covariance(kSlopeX, kSlopeX), 0.02 * 0.02);
}

TEST(BodyBelief, LearnsFromFeedbackOfTheJointsWhatABadPoseDoesNotTell) {
  BeliefOptions options;
  options.measurement_noise_m = 0.3;
  options.measurement_noise_rad = 1.0;
  WalkedBody body("left_middle: locked");
  BodyBelief blind(imagination(), Physics(), options), feeling = blind;
  SeenBehavior seen = body.walk(walkingGaits()[3], options.measurement_noise_m);
  blind.observe(seen);
  EXPECT_EQ(believed(blind), "intact");
  seen.joints = body.joints();
  feeling.observe(seen);
  EXPECT_EQ(believed(feeling), "left_middle: locked");
  EXPECT_GT(feeling.probability(0), 0.5);
}

TEST(BodyBelief, TakesALegWhoseJointsAreNotReadForAMissingOne) {
  BeliefOptions options;
  options.measurement_noise_m = 0.3;
  options.measurement_noise_rad = 1.0;
  WalkedBody body("right_rear: missing");
  BodyBelief belief(imagination(), Physics(), options);
  SeenBehavior seen = body.walk(walkingGaits()[3], options.measurement_noise_m);
  seen.joints = body.joints();
  const std::size_t leg = legNumber("right_rear");
  for (std::size_t k = 0; k < 3; ++k) seen.joints[3 * leg + k] = {NAN, NAN};
  belief.observe(seen);
  EXPECT_EQ(believed(belief), "right_rear: missing");
  EXPECT_GT(belief.probability(0), 0.9);
}

TEST(BodyBelief, IsTheSameForAnyNumberOfThreads) {
  std::vector<double> weights[2];
  for (int threads = 1; threads <= 2; ++threads) {
    WalkedBody body("right_rear: lifted");
    BodyBelief belief(imagination(threads), Physics(), BeliefOptions());
    watch(body, 2, belief);
    for (const BelievedBody& one : belief.bodies()) {
      weights[threads - 1].push_back(one.log_weight);
      weights[threads - 1].push_back(one.mean[kFriction]);
    }
  }
  EXPECT_EQ(weights[0], weights[1]);
}

TEST(BodyBelief, KnowsWhatItWasTold) {
  Physics told;
  told.friction_scale = 0.6;
  told.slope_y_rad = 0.02;
  told.legs = legStatesFromText(shippedRobot(), "left_rear: locked");
  BodyBelief belief(imagination(), told);
  WalkedBody body("", Physics());
  watch(body, 2, belief);
  ASSERT_EQ(belief.bodies().size(), 1u);
  const Physics physics = belief.physicsOf(belief.bodies().front());
  EXPECT_EQ(physics.friction_scale, 0.6);
  EXPECT_EQ(physics.slope_y_rad, 0.02);
  EXPECT_EQ(physics.legs[0].condition, LegCondition::kLocked);
}

}  // namespace
}  // namespace hexapod
