#include "execution/joint_map.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "shipped_robot.h"

namespace hexapod {
namespace {

const std::vector<std::string> kNames = {"hip", "knee"};

std::string contents(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(JointMap, AppliesSignAndOffsetAndTakesThemBack) {
  const JointMap map = JointMap::fromYaml(
      "joints: {knee: {name: servo_2, sign: -1, offset_rad: 0.25}, hip: {name: servo_1}}", kNames,
      "map");
  EXPECT_EQ(map.wireNames(), (std::vector<std::string>{"servo_1", "servo_2"}));
  std::vector<double> wire;
  map.toWire({0.1, 0.2}, wire);
  EXPECT_DOUBLE_EQ(wire[0], 0.1);
  EXPECT_DOUBLE_EQ(wire[1], -0.2 + 0.25);
  std::vector<double> angles;
  map.fromWire(wire, angles);
  EXPECT_DOUBLE_EQ(angles[0], 0.1);
  EXPECT_DOUBLE_EQ(angles[1], 0.2);
}

TEST(JointMap, NamesEveryProblemAtOnce) {
  try {
    JointMap::fromYaml(
        "joints: {hip: {sgn: 1, sign: 2, name: a, offset_rad: .nan}, toe: {}, knee: {name: a}}",
        kNames, "map.yaml");
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    const std::string text = error.what();
    for (const char* says : {"map.yaml", "'sgn' of joint 'hip' is unknown", "must be 1 or -1",
                             "'offset_rad' of joint 'hip' must be", "joint 'toe' is not one",
                             "'a' is given to two joints"}) {
      EXPECT_NE(text.find(says), std::string::npos) << says << "\n" << text;
    }
  }
}

TEST(JointMap, RefusesWhatIsNoMap) {
  for (const char* text : {"", "joints: 3", "{joints: {hip: {}}, knee: {}}", "joints: {hip: {}}",
                           "joints: {hip: 3, knee: {}}", "{", "- a"}) {
    EXPECT_THROW(JointMap::fromYaml(text, kNames, "map"), std::runtime_error) << text;
  }
}

TEST(JointMap, ShippedMapsFitTheShippedRobot) {
  const std::vector<std::string> names = shippedRobot().jointNames();
  const JointMap identity = JointMap::identity(names);
  const JointMap shipped =
      JointMap::fromYaml(contents("config/joint_map_hexapod.yaml"), names, "hexapod");
  EXPECT_EQ(shipped.wireNames(), identity.wireNames());
  std::vector<double> wire;
  shipped.toWire(shippedRobot().neutralPose(), wire);
  EXPECT_EQ(wire, shippedRobot().neutralPose());
  for (const char* other : {"phantomx", "interbotix", "openshc"}) {
    EXPECT_NO_THROW(JointMap::fromYaml(contents("config/joint_map_" + std::string(other) + ".yaml"),
                                       names, other));
  }
}

}  // namespace
}  // namespace hexapod
