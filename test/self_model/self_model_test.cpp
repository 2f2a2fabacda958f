#include "self_model/self_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "gait/random_genome.h"
#include "simulation/body_text.h"
#include "simulation/rollout.h"
#include "walked_body.h"

namespace hexapod {
namespace {

std::shared_ptr<const Repertoire> repertoire() {
  auto made = std::make_shared<Repertoire>();
  for (const Genome& gait : walkingGaits()) {
    Entry entry;
    entry.id = static_cast<std::int64_t>(made->entries.size()) + 1;
    entry.genome = gait;
    entry.end_pose = {0.1, 0.0, 0.1};  // not standing still, as it will be known
    made->entries.push_back(entry);
  }
  return made;
}

SelfModelOptions oneThread() {
  SelfModelOptions options;
  options.threads = 1;
  return options;
}

WalkedStep stepOf(const Entry& entry, const SeenBehavior& seen) {
  return {entry, seen.world_from_before, seen.world_from_after, {}};
}

double off_m(const SelfModel& self_model, const Entry& expected, const SeenBehavior& seen) {
  Pose2 end = seen.world_from_before * expected.execution->mean;
  end.x_m += self_model.drift_m().x();
  end.y_m += self_model.drift_m().y();
  return distance(end, seen.world_from_after);
}

TEST(SelfModel, ForeseesTheNextBehaviourOfAnIntactRobot) {
  const auto known = repertoire();
  WalkedBody body("");
  SelfModel self_model(body.robot(), LearnedWorld(), oneThread());
  for (int i = 0; i < 6; ++i) {
    const std::size_t k = i % known->entries.size();
    const auto expected = self_model.expected(known);
    const Pose2 followed = self_model.follow(body.pose(), {known->entries[k]}).at(0);
    const SeenBehavior seen = body.walk(known->entries[k].genome);
    EXPECT_LT(off_m(self_model, expected->entries[k], seen), 0.01);
    EXPECT_LT(distance(followed, seen.world_from_after), 1e-4);
    self_model.observe(stepOf(known->entries[k], seen));
  }
}

TEST(SelfModel, ForeseesADamagedRobotOnASlopeAfterTwoBehaviours) {
  const auto known = repertoire();
  Physics slope;
  slope.slope_x_rad = 0.02;
  slope.slope_y_rad = -0.02;
  WalkedBody body("left_middle: lifted", slope);
  SelfModel self_model(body.robot(), LearnedWorld(), oneThread());
  for (int i = 0; i < 6; ++i) {
    const std::size_t k = i % known->entries.size();
    const auto expected = self_model.expected(known);
    const Pose2 followed = self_model.follow(body.pose(), {known->entries[k]}).at(0);
    const SeenBehavior seen = body.walk(known->entries[k].genome);
    const double off = off_m(self_model, expected->entries[k], seen);
    EXPECT_TRUE(i != 0 || off > 0.04) << off;
    EXPECT_TRUE(i < 3 || off < 0.03) << i << ": " << off;
    EXPECT_TRUE(i < 3 || distance(followed, seen.world_from_after) < 0.02) << i;
    self_model.observe(stepOf(known->entries[k], seen));
  }
  // Downhill.
  EXPECT_LT(self_model.drift_m().x(), -0.005);
  EXPECT_GT(self_model.drift_m().y(), 0.005);
}

// A gait with which a body falls from its stand.
Genome fallingGait(const RobotDescription& robot, const Physics& body) {
  const Imagination imagination(robot, BehaviorOptions(), Engine::kReduced, 1);
  const WorldState stand = *imagination.stands({body}).front();
  Random random(1);
  while (true) {
    Genome genome = randomGenome(random);
    if (imagination.play(genome, {{body, &stand}}).front().verdict == Verdict::kFell) return genome;
  }
}

TEST(SelfModel, ExpectsARobotThatFellToHaveBeenStoodUp) {
  const RobotDescription& robot = shippedRobot();
  const Physics limp = bodyFromText(robot, "right_rear: limp", Physics());
  SelfModel self_model(robot, LearnedWorld(), oneThread(), limp);
  const auto known = repertoire();
  const auto before = self_model.expected(known);
  Entry falls = known->entries.front();
  falls.genome = fallingGait(robot, limp);
  self_model.observe(stepOf(falls, {falls.genome, Pose2(), Pose2(), {}}));
  const auto after = self_model.expected(known);
  int walks = 0;
  for (std::size_t i = 0; i < known->entries.size(); ++i) {
    EXPECT_EQ(after->entries[i].execution->falls, before->entries[i].execution->falls);
    walks += after->entries[i].execution->falls == 0 ? 1 : 0;
  }
  EXPECT_GT(walks, 0);
}

TEST(SelfModel, FollowsAChainToWhereItLeads) {
  const auto known = repertoire();
  Physics slope;
  slope.slope_x_rad = 0.04;
  WalkedBody body("", slope);
  SelfModel self_model(body.robot(), LearnedWorld(), oneThread(), slope);
  const std::vector<Pose2> poses = self_model.follow(Pose2(), known->entries);
  ASSERT_EQ(poses.size(), known->entries.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const SeenBehavior seen = body.walk(known->entries[i].genome);
    EXPECT_LT(distance(poses[i], seen.world_from_after), 0.005) << i;
    EXPECT_LT(headingDistance(poses[i], seen.world_from_after), 0.02) << i;
  }
}

TEST(SelfModel, IsWaryAtFirstOfWhatFallsWithALimpLeg) {
  const auto known = std::make_shared<Repertoire>(*repertoire());
  WalkedBody body("");
  known->entries.front().genome =
      fallingGait(body.robot(), bodyFromText(body.robot(), "left_front: limp"));
  SelfModel self_model(body.robot(), LearnedWorld(), oneThread());
  EXPECT_EQ(self_model.caution(known), nullptr) << "not prepared";
  self_model.prepare(known, [] { return true; });
  EXPECT_EQ(self_model.caution(known), nullptr) << "stopped";
  self_model.prepare(known, [] { return false; });
  const auto prices = self_model.caution(known);
  ASSERT_TRUE(prices);
  ASSERT_EQ(prices->size(), known->entries.size());
  EXPECT_GE(prices->front(), 0.6);
  for (const double price : *prices) {
    EXPECT_GE(price, 0.0);
    EXPECT_LE(price, 1.2);
  }
  EXPECT_EQ(self_model.caution(repertoire()), nullptr) << "of another one";
  EXPECT_EQ(SelfModel(self_model).caution(known), prices);
  const Entry& walked = known->entries[1];
  self_model.observe(stepOf(walked, body.walk(walked.genome)));
  EXPECT_EQ(self_model.caution(known), nullptr) << "something was measured";
  self_model.forget();
  EXPECT_EQ(self_model.caution(known), prices);
}

TEST(SelfModel, FollowsNoChainThatFails) {
  const auto known = repertoire();
  Physics told;
  told.legs = legStatesFromText(shippedRobot(), "left_rear: lifted, right_front: lifted");
  SelfModel self_model(shippedRobot(), LearnedWorld(), oneThread(), told);
  const auto expected = self_model.expected(known);
  for (std::size_t i = 0; i < known->entries.size(); ++i) {
    EXPECT_EQ(self_model.follow(Pose2(), {known->entries[i]}).empty(),
              !expected->entries[i].usable());
  }
}

TEST(SelfModel, LeavesOutWhatFailsInItsBody) {
  const auto known = repertoire();
  Physics told;
  told.legs = legStatesFromText(shippedRobot(), "left_rear: lifted, right_front: lifted");
  SelfModel self_model(shippedRobot(), LearnedWorld(), oneThread(), told);
  const auto expected = self_model.expected(known);
  ASSERT_EQ(expected->entries.size(), known->entries.size());
  for (std::size_t i = 0; i < known->entries.size(); ++i) {
    EXPECT_EQ(expected->entries[i].id, known->entries[i].id);
    WalkedBody body("left_rear: lifted, right_front: lifted");
    const auto world = makeWorld(Engine::kReduced, body.robot(), told);
    const Outcome outcome =
        play(*world, Behavior(body.robot(), known->entries[i].genome, BehaviorOptions()), 0.030);
    EXPECT_EQ(expected->entries[i].usable(), outcome.walked());
    if (!outcome.walked()) continue;
    EXPECT_LT(distance(expected->entries[i].execution->mean, outcome.end_pose), 1e-4);
  }
}

TEST(SelfModel, LearnsWhatItsBodyDoesNotExplainAndForgetsIt) {
  const auto known = repertoire();
  SelfModel self_model(shippedRobot(), LearnedWorld(), oneThread(), Physics());
  // Everything leads a fifth too far, in a body that is known for sure.
  const Deviation truth{1.2, 0.0, 1.0, 0.0};
  const auto nominal = self_model.expected(known);
  Pose2 pose;
  for (int i = 0; i < 8; ++i) {
    const std::size_t k = i % known->entries.size();
    // Where the body itself is thought to lead from where it stands.
    WalkedStep step{known->entries[k], pose, pose, {}};
    SelfModel blind(self_model);
    blind.observe(step);
    const Pose2 imagined = blind.belief().bodies().front().imagined.start_from_end;
    step.world_from_after = pose = pose * truth.apply(imagined);
    self_model.observe(step);
  }
  const auto expected = self_model.expected(known);
  for (std::size_t k = 0; k < known->entries.size(); ++k) {
    const double far_m = distance(expected->entries[k].execution->mean, Pose2());
    EXPECT_NEAR(far_m / distance(nominal->entries[k].execution->mean, Pose2()), 1.2, 0.06);
  }
  self_model.forget();
  const auto again = self_model.expected(known);
  for (std::size_t k = 0; k < known->entries.size(); ++k) {
    EXPECT_LT(distance(again->entries[k].execution->mean, nominal->entries[k].execution->mean),
              0.005);
  }
}

TEST(SelfModel, ExpectsTheSameUntilItHasSeenMore) {
  const auto known = repertoire();
  SelfModel self_model(shippedRobot(), LearnedWorld(), oneThread());
  const auto expected = self_model.expected(known);
  EXPECT_EQ(self_model.expected(known), expected);
  SelfModel other(self_model);
  EXPECT_EQ(other.expected(known), expected);
  WalkedBody body("");
  self_model.observe(stepOf(known->entries[0], body.walk(known->entries[0].genome)));
  EXPECT_NE(self_model.expected(known), expected);
  EXPECT_EQ(other.expected(known), expected);
}

}  // namespace
}  // namespace hexapod
