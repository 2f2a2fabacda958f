#include "tools/walk_bodies.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "robot/load_robot.h"

namespace hexapod {
namespace {

const RobotDescription& robot() {
  static const RobotDescription robot = loadRobot("urdf/hexapod.urdf", "config/hexapod.yaml");
  return robot;
}

TEST(WalkBodies, AreSeparatedBySemicolons) {
  const auto bodies = bodiesFromText(robot(), " intact; left_middle: limp, friction: 0.7 ;");
  ASSERT_EQ(bodies.size(), 2u);
  EXPECT_EQ(bodies[0].name, "intact");
  EXPECT_TRUE(bodies[0].physics.legs.empty());
  EXPECT_EQ(bodies[1].name, "left_middle: limp, friction: 0.7");
  EXPECT_EQ(bodies[1].physics.friction_scale, 0.7);
}

TEST(WalkBodies, AllAreThoseOfTheCampaign) {
  EXPECT_EQ(bodiesFromText(robot(), "all").size(), campaignBodies(robot()).size());
  EXPECT_GT(campaignBodies(robot()).size(), 20u);
}

TEST(WalkBodies, NamesWhatIsNoBody) {
  EXPECT_THROW(bodiesFromText(robot(), ";"), std::invalid_argument);
  EXPECT_THROW(bodiesFromText(robot(), "intact; tail: limp"), std::invalid_argument);
}

}  // namespace
}  // namespace hexapod
