#include "simulation/body_text.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "test_robots.h"

namespace hexapod {
namespace {

std::string complaint(const RobotDescription& robot, const std::string& text) {
  try {
    bodyFromText(robot, text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(BodyText, NamesLegsAndWhatDiffersByDegrees) {
  const RobotDescription robot = handMadeHexapod();
  const std::string leg = robot.legs[1].name;
  Physics otherwise;
  otherwise.step_s = 0.003;
  const Physics body =
      bodyFromText(robot, " friction : 0.7," + leg + ": limp, slope_y: -0.02", otherwise);
  EXPECT_EQ(body.friction_scale, 0.7);
  EXPECT_EQ(body.slope_y_rad, -0.02);
  EXPECT_EQ(body.step_s, 0.003);
  EXPECT_EQ(body.mass_scale, 1.0);
  ASSERT_EQ(body.legs.size(), robot.legs.size());
  EXPECT_EQ(body.legs[1].condition, LegCondition::kLimp);
}

TEST(BodyText, KnowsTheNamesOfTheFieldsAsWell) {
  const RobotDescription robot = handMadeHexapod();
  const std::string fields =
      "friction_scale: 0.5, mass_scale: 0.6, servo_gain_scale: 0.7, torque_scale: 0.8, "
      "slope_x_rad: 0.01, slope_y_rad: 0.02, command_latency_s: 0.03, step_s: 0.005";
  EXPECT_EQ(bodyText(robot, bodyFromText(robot, fields)),
            "friction: 0.5, mass: 0.6, gain: 0.7, torque: 0.8, slope_x: 0.01, slope_y: 0.02, "
            "latency: 0.03, step: 0.005");
}

TEST(BodyText, ReadsBackWhatItTells) {
  const RobotDescription robot = handMadeHexapod();
  Physics body;
  body.servo_gain_scale = 1.0 / 3.0;
  body.legs.resize(robot.legs.size());
  body.legs[4].condition = LegCondition::kMissing;
  const Physics again = bodyFromText(robot, bodyText(robot, body));
  EXPECT_EQ(again.servo_gain_scale, body.servo_gain_scale);
  EXPECT_EQ(again.legs, body.legs);
}

TEST(BodyText, IsIntactWhenNothingDiffers) {
  const RobotDescription robot = handMadeHexapod();
  EXPECT_EQ(bodyText(robot, bodyFromText(robot, "")), "intact");
  EXPECT_EQ(bodyText(robot, bodyFromText(robot, "intact")), "intact");
  Physics fine;
  fine.step_s = 0.003;
  EXPECT_EQ(bodyText(robot, fine, fine), "intact");
  EXPECT_EQ(bodyText(robot, fine), "step: 0.003");
}

TEST(BodyText, TellsWhatIsWrongAndWhatWasExpected) {
  const RobotDescription robot = handMadeHexapod();
  const std::string leg = robot.legs[0].name;
  const auto says = [&](const std::string& text, const std::string& words) {
    EXPECT_NE(complaint(robot, text).find(words), std::string::npos) << complaint(robot, text);
  };
  says("tail: limp", "'tail' is nothing of a body; expected a leg (" + leg);
  says("tail: limp", "or one of friction, mass, gain");
  says(leg + ": broken", "'broken' is no condition of a leg");
  says("friction", "'friction' says nothing of a body");
  says("friction: low", "'friction: low' has no number after the colon");
  says("friction: -1", "friction_scale must be between 0 and 100, found -1");
}

}  // namespace
}  // namespace hexapod
