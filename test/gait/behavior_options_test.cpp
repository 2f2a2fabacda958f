#include "gait/behavior_options.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "made_robot.h"

namespace hexapod {
namespace {

using Edit = std::function<void(BehaviorOptions&)>;

std::string complaint(const Edit& edit) {
  BehaviorOptions options;
  edit(options);
  return complaintOf([&] { checkReturnIsSlowEnough(madeRobot(6, 3), options); });
}

TEST(BehaviorOptions, DefaultsGiveThreeSecondsOfGaitAndAReturn) {
  const BehaviorParts parts = behaviorParts(BehaviorOptions());
  EXPECT_EQ(parts.gait, 100u);
  EXPECT_EQ(parts.way_back, 20u);
  EXPECT_EQ(parts.rest, 10u);
  EXPECT_EQ(parts.total(), 130u);
  EXPECT_EQ(complaint([](auto&) {}), "");
}

TEST(BehaviorOptions, WholeMultiplesOfAnyPeriodAreAccepted) {
  BehaviorOptions options;
  for (double period_s : {0.01, 0.015, 0.02, 0.025, 0.03, 0.05, 0.1}) {
    options.command_period_s = period_s;
    EXPECT_EQ(behaviorParts(options).gait, std::llround(3.0 / period_s));
  }
}

TEST(BehaviorOptions, WrongValueIsRefusedNamingOptionAndValue) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const std::vector<std::pair<Edit, std::string>> cases = {
      {[&](auto& o) { o.gait_duration_s = nan; }, "gait_duration_s is nan"},
      {[&](auto& o) { o.gait_duration_s = inf; }, "gait_duration_s is inf"},
      {[](auto& o) { o.gait_duration_s = 0.0; }, "gait_duration_s is 0"},
      {[](auto& o) { o.gait_duration_s = 1e9; }, "gait_duration_s is 1e+09"},
      {[](auto& o) { o.gait_duration_s = 3.01; }, "gait_duration_s is 3.01"},
      {[](auto& o) { o.gait_duration_s = 0.002; }, "such as 0.03 s"},
      {[](auto& o) { o.command_period_s = 0.0; }, "command_period_s is 0"},
      {[](auto& o) { o.command_period_s = -0.03; }, "command_period_s is -0.03"},
      {[&](auto& o) { o.command_period_s = nan; }, "command_period_s is nan"},
      {[](auto& o) { o.return_duration_s = -0.3; }, "return_duration_s is -0.3"},
      {[](auto& o) { o.return_duration_s = 0.61; }, "return_duration_s is 0.61"},
      {[](auto& o) { o.rest_duration_s = -0.3; }, "rest_duration_s is -0.3"},
      {[](auto& o) { o.end_pose = "atrest"; }, "end_pose is \"atrest\"; expected at_rest or after"},
      {[](auto& o) { o.return_duration_s = o.rest_duration_s = 0.0; }, "both 0"},
  };
  for (const auto& [edit, expected] : cases) {
    EXPECT_NE(complaint(edit).find(expected), std::string::npos) << expected << complaint(edit);
  }
}

TEST(BehaviorOptions, ReturnFasterThanAJointIsRefusedNamingBoth) {
  // pi/4 rad at 6.28 rad/s take 0.12506 s: 5 commands of 30 ms do, 4 do not.
  EXPECT_EQ(complaint([](auto& o) { o.return_duration_s = 0.15; }), "");
  const std::string said = complaint([](auto& o) { o.return_duration_s = 0.12; });
  EXPECT_NE(said.find("return_duration_s is 0.12 s; joint joint_0_1"), std::string::npos) << said;
  EXPECT_NE(said.find("0.125"), std::string::npos) << said;
  EXPECT_NE(complaint([](auto& o) { o.return_duration_s = 0.0; }), "");
  EXPECT_EQ(complaint([](auto& o) {
              o.return_duration_s = 0.0;
              o.limit_velocity = false;
            }),
            "");
  EXPECT_EQ(complaint([](auto& o) {
              o.return_duration_s = 0.0;
              o.end_pose = EndPose::kAfterGait;
            }),
            "");
}

TEST(BehaviorOptions, AreDeclaredOnceWithTheirDefaults) {
  BehaviorOptions options;
  const std::vector<Option> declared = declareOptions(options);
  ASSERT_EQ(declared.size(), 7u);
  applyOptions(declared,
               {{"gait_duration_s", 1.5},
                {"end_pose", std::string("after_gait")},
                {"limit_velocity", false},
                {"command_period_s", 0.015}},
               "test");
  EXPECT_EQ(options.gait_duration_s, 1.5);
  EXPECT_EQ(options.end_pose, EndPose::kAfterGait);
  EXPECT_FALSE(options.limit_velocity);
  EXPECT_EQ(behaviorParts(options).total(), 100u);
  EXPECT_THROW(applyOptions(declared, {{"end_pose", std::string("later")}}, "test"),
               std::invalid_argument);
}

}  // namespace
}  // namespace hexapod
