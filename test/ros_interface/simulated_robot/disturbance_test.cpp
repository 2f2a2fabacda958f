#include "ros_interface/simulated_robot/disturbance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "execution/shipped_robot.h"
#include "ros_interface/simulated_robot/repertoire_check.h"
#include "ros_interface/simulated_robot/simulated_robot_options.h"

namespace hexapod {
namespace {

using Request = hexapod_repertoire::Disturb::Request;

std::string complaintOf(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

Disturbance from(const Request& request, const Disturbance& started_with = {}) {
  std::vector<double> angles_rad(18);
  for (std::size_t j = 0; j < angles_rad.size(); ++j) angles_rad[j] = 0.01 * static_cast<double>(j);
  return disturbanceFrom(request, started_with, shippedRobot(), angles_rad);
}

std::string complaintOf(const Request& request) {
  return complaintOf([&] { from(request); });
}

TEST(Disturbance, AnEmptyRequestIsHowTheRobotWasStarted) {
  Disturbance started_with;
  started_with.physics.friction_scale = 0.7;
  started_with.physics.legs = legStatesFromText(shippedRobot(), "right_rear: limp");
  started_with.dead_band_rad = 0.01;
  const Disturbance disturbance = from({}, started_with);
  EXPECT_EQ(disturbance.physics.friction_scale, 0.7);
  EXPECT_EQ(disturbance.physics.legs, started_with.physics.legs);
  EXPECT_EQ(disturbance.dead_band_rad, 0.01);
}

TEST(Disturbance, ScalesMultiplyAndTheRestAddsToHowItWasStarted) {
  Disturbance started_with;
  started_with.physics.friction_scale = 0.5;
  started_with.latency_s = 0.01;
  Request request;
  request.friction_scale = 0.6;
  request.latency_s = 0.02;
  request.slope_y_rad = 0.1;
  const Disturbance disturbance = from(request, started_with);
  EXPECT_NEAR(disturbance.physics.friction_scale, 0.3, 1e-12);
  EXPECT_NEAR(disturbance.latency_s, 0.03, 1e-12);
  EXPECT_EQ(disturbance.physics.slope_y_rad, 0.1);
  EXPECT_EQ(disturbance.physics.mass_scale, 1.0);
}

TEST(Disturbance, ALegIsLockedWhereItsJointsAre) {
  Request request;
  request.legs = {shippedRobot().legs[2].name};
  request.states = {Request::LOCKED};
  const Disturbance disturbance = from(request);
  ASSERT_EQ(disturbance.physics.legs.size(), 6u);
  EXPECT_EQ(disturbance.physics.legs[2].condition, LegCondition::kLocked);
  EXPECT_EQ(disturbance.physics.legs[2].locked_rad, (std::vector<double>{0.06, 0.07, 0.08}));
  EXPECT_EQ(disturbance.physics.legs[1].condition, LegCondition::kIntact);
  EXPECT_NE(describe(disturbance, shippedRobot()).find(request.legs[0] + ": locked"),
            std::string::npos);
}

TEST(Disturbance, RefusesWhatCannotBeWithASentence) {
  Request request;
  request.legs = {"tail"};
  request.states = {Request::LIMP};
  EXPECT_NE(complaintOf(request).find("no leg 'tail'"), std::string::npos);
  EXPECT_NE(complaintOf(request).find(shippedRobot().legs[5].name), std::string::npos);
  request.states = {};
  EXPECT_NE(complaintOf(request).find("1 legs and 0 states"), std::string::npos);
  request.legs = {shippedRobot().legs[0].name};
  request.states = {9};
  EXPECT_NE(complaintOf(request).find("is 9; expected 0 (intact)"), std::string::npos);
  for (const double wrong : {-0.1, 1.1, static_cast<double>(NAN), static_cast<double>(INFINITY)}) {
    Request scaled;
    scaled.dropped_share = wrong;
    EXPECT_NE(complaintOf(scaled).find("dropped_share is"), std::string::npos) << wrong;
  }
  Request heavy;
  heavy.mass_scale = -3.0;
  EXPECT_NE(complaintOf(heavy).find("mass_scale"), std::string::npos);
}

TEST(SimulatedRobotOptions, TimeRunsAtOneSpeedForAll) {
  SimulatedRobotOptions options;
  EXPECT_NO_THROW(checkTime(options, false));
  EXPECT_NE(complaintOf([&] { checkTime(options, true); }).find("~publish_clock is not"),
            std::string::npos);
  options.real_time_factor = 4.0;
  EXPECT_NE(complaintOf([&] { checkTime(options, false); }).find("needs ~publish_clock"),
            std::string::npos);
  options.publish_clock = true;
  EXPECT_NO_THROW(checkTime(options, true));
  EXPECT_NE(complaintOf([&] { checkTime(options, false); }).find("/use_sim_time is not"),
            std::string::npos);
}

TEST(RepertoireCheck, NamesBothRobotsWhenARepertoireIsForAnother) {
  hexapod_repertoire::Repertoire repertoire;
  EXPECT_EQ(wrongRobot(repertoire, "this"), "") << "it does not say for which";
  repertoire.robot_id = "this";
  EXPECT_EQ(wrongRobot(repertoire, "this"), "");
  const std::string sentence = wrongRobot(repertoire, "other");
  EXPECT_NE(sentence.find("for the robot this, the simulated one is other"), std::string::npos);
}

}  // namespace
}  // namespace hexapod
