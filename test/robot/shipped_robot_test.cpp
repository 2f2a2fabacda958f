#include <gtest/gtest.h>

#include <cmath>

#include "robot/load_robot.h"

namespace hexapod_repertoire {
namespace {

RobotDescription shipped() { return loadRobot("urdf/hexapod.urdf", "config/hexapod.yaml"); }

TEST(ShippedRobot, HasSixLegsOfThreeServosInTheDocumentedOrder) {
  const RobotDescription robot = shipped();
  EXPECT_EQ(robot.name, "hexapod");
  EXPECT_EQ(robot.base_link, "base_link");
  ASSERT_EQ(robot.legs.size(), 6u);
  EXPECT_EQ(robot.jointCount(), 18u);
  EXPECT_EQ(robot.geneCount(), 24u);
  EXPECT_EQ(robot.legs[0].name, "left_rear");
  EXPECT_EQ(robot.legs[5].name, "right_rear");
  EXPECT_EQ(robot.jointNames()[0], "body_leg_0");
  EXPECT_EQ(robot.jointNames()[4], "leg_1_1_2");
  EXPECT_EQ(robot.jointNames()[17], "leg_5_2_3");
}

}  // namespace
}  // namespace hexapod_repertoire
