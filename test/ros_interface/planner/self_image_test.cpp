#include "ros_interface/planner/self_image.h"

#include <gtest/gtest.h>

#include <vector>

#include "ros_interface/fake_clock.h"
#include "self_model/walked_body.h"

namespace hexapod {
namespace {

using hexapod_repertoire::BodyBelief;

Repertoire repertoireOf(const std::string& robot_id) {
  Repertoire repertoire;
  repertoire.run_id = "run";
  repertoire.robot_id = robot_id;
  for (const Genome& gait : walkingGaits()) {
    Entry entry;
    entry.id = static_cast<std::int64_t>(repertoire.entries.size()) + 1;
    entry.genome = gait;
    repertoire.entries.push_back(entry);
  }
  return repertoire;
}

class SelfImageTest : public testing::Test {
 protected:
  FakeClock clock_;
  std::vector<BodyBelief> told_;
  SelfImage image_{clock_, shippedRobot(),
                   [this](const BodyBelief& belief) { told_.push_back(belief); }};
};

TEST_F(SelfImageTest, TellsWhichLegIsOutOfOrderAndForgetsItWhenAskedTo) {
  const Repertoire repertoire = repertoireOf(shippedRobot().digest);
  const auto foresight = image_.foresightFor(repertoire);
  ASSERT_EQ(told_.size(), 1u);
  EXPECT_EQ(told_[0].bodies.front(), "intact");
  EXPECT_EQ(told_[0].behaviors, 0u);
  EXPECT_TRUE(told_[0].dead_joints.empty());
  WalkedBody body("left_middle: lifted");
  for (const Entry& entry : {repertoire.entries[0], repertoire.entries[1]}) {
    const SeenBehavior seen = body.walk(entry.genome);
    foresight->observe({entry, seen.world_from_before, seen.world_from_after, {}});
  }
  ASSERT_EQ(told_.size(), 3u);
  EXPECT_EQ(told_[2].bodies.front(), "left_middle: lifted");
  EXPECT_GT(told_[2].probabilities.front(), 0.8);
  EXPECT_EQ(told_[2].behaviors, 2u);
  EXPECT_EQ(told_[2].dead_joints,
            (std::vector<std::string>{"body_leg_1", "leg_1_1_2", "leg_1_2_3"}));
  EXPECT_EQ(told_[2].parameters.size(), told_[2].values.size());
  EXPECT_EQ(told_[2].sentence.find("left_middle: lifted ("), 0u) << told_[2].sentence;
  const std::vector<Pose2> followed = foresight->follow(Pose2(), {repertoire.entries[0]});
  ASSERT_EQ(followed.size(), 1u);
  const SeenBehavior seen = body.walk(repertoire.entries[0].genome);
  EXPECT_LT(distance(followed[0], seen.startFromEnd()), 0.01);
  image_.forget();
  ASSERT_EQ(told_.size(), 4u);
  EXPECT_EQ(told_[3].bodies.front(), "intact");
  EXPECT_EQ(told_[3].behaviors, 0u);
}

TEST_F(SelfImageTest, TellsAgainWithTheTimeOfNow) {
  image_.tellAgain();
  EXPECT_TRUE(told_.empty());
  EXPECT_EQ(image_.told().sentence, "");
  const auto foresight = image_.foresightFor(repertoireOf(shippedRobot().digest));
  clock_.waitUntil(clock_.steadyNow_ns() + kSecond_ns, [] { return false; });
  image_.tellAgain();
  ASSERT_EQ(told_.size(), 2u);
  EXPECT_EQ(told_[1].robot_id, shippedRobot().digest);
  EXPECT_EQ(told_[1].sentence, told_[0].sentence);
  EXPECT_EQ((told_[1].header.stamp - told_[0].header.stamp).toSec(), 1.0);
  EXPECT_EQ(image_.told().sentence, told_[0].sentence);
  image_.foresightFor(repertoireOf("of another robot"));
  image_.tellAgain();
  EXPECT_EQ(told_.size(), 2u) << "nothing is believed any more";
}

TEST_F(SelfImageTest, TellsNothingOfARobotItCannotSimulate) {
  EXPECT_NE(image_.foresightFor(repertoireOf("of another robot")), nullptr);
  Repertoire odd = repertoireOf(shippedRobot().digest);
  odd.options["command_period_s"] = "-1";
  EXPECT_NE(image_.foresightFor(odd), nullptr);
  EXPECT_TRUE(told_.empty());
  EXPECT_NE(image_.forget().find("not simulated"), std::string::npos);
}

}  // namespace
}  // namespace hexapod
