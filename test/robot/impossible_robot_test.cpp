#include <gtest/gtest.h>

#include "shipped_files.h"

namespace hexapod {
namespace {

// The shipped robot with one text replaced by another in one of its files.
struct Case {
  std::string file;
  std::string from;
  std::string to;
  std::vector<std::string> expected;  // all in one complaint
};

void expectComplaint(const Case& c) {
  const std::string shipped_urdf = contentOf(kUrdfFile);
  const std::string shipped_yaml = contentOf(kYamlFile);
  const bool in_urdf = c.file == kUrdf;
  const std::string said = complaint(in_urdf ? replaced(shipped_urdf, c.from, c.to) : shipped_urdf,
                                     in_urdf ? shipped_yaml : replaced(shipped_yaml, c.from, c.to));
  EXPECT_FALSE(said.empty()) << "accepted instead of " << c.from << ": " << c.to;
  for (const std::string& part : c.expected) {
    EXPECT_NE(said.find(part), std::string::npos)
        << "instead of " << c.from << ": " << c.to << "\nexpected " << part << "\nsaid " << said;
  }
}

const char* const kCoxaMass = "<mass value=\"0.02\"/>";
const char* const kLimit =
    "<limit lower=\"-1.57079632679\" upper=\"1.57079632679\" effort=\"1.5\" velocity=\"6.28\"/>";
const char* const kCylinder =
    "<collision>\n      <origin xyz=\"0.03 0 0\" rpy=\"0 "
    "1.5707963267948966 0\"/>\n      <geometry><cylinder radius=\"0.02\" "
    "length=\"0.06\"/></geometry>\n    </collision>";

std::string collision(const std::string& geometry) {
  return "<collision><geometry>" + geometry + "</geometry></collision>";
}

TEST(ImpossibleRobot, LinkThatCannotExistIsNamed) {
  const std::vector<Case> cases = {
      {kUrdf, kCoxaMass, "<mass value=\"0\"/>", {"link leg_0_1 and what is fixed", "no mass"}},
      {kUrdf,
       kCoxaMass,
       "<mass value=\"-1\"/>",
       {"link leg_0_1 has mass -1 kg; expected 0 or more."}},
      {kUrdf, kCoxaMass, "<mass value=\"nan\"/>", {"leg_0_1"}},
      {kUrdf, kCoxaMass, "<mass value=\"1e999\"/>", {"leg_0_1"}},
      {kUrdf, kCoxaMass, "<mass value=\"0,02\"/>", {"leg_0_1"}},
      {kUrdf, kCoxaMass, "", {"leg_0_1"}},
      {kUrdf, "ixx=\"3.54285714e-06\"", "ixx=\"1\"", {"link leg_0_1", "impossible inertia"}},
      {kUrdf, "ixx=\"3.54285714e-06\"", "ixx=\"0\"", {"link leg_0_1", "impossible inertia"}},
      {kUrdf,
       "ixy=\"0\" ixz=\"0\" iyz=\"0\"/>\n    </inertial>\n    <visual>\n      <origin xyz=\"0.03",
       "ixy=\"1\" ixz=\"0\" iyz=\"0\"/>\n    </inertial>\n    <visual>\n      <origin xyz=\"0.03",
       {"link leg_0_1", "impossible inertia"}},
      {kUrdf,
       kCylinder,
       collision("<cylinder radius='-0.02' length='0.06'/>"),
       {"link leg_0_1", "radius -0.02 m"}},
      {kUrdf,
       kCylinder,
       collision("<cylinder radius='0.02' length='0'/>"),
       {"link leg_0_1", "length 0 m; expected both above 0 m"}},
      {kUrdf, kCylinder, collision("<sphere radius='0'/>"), {"link leg_0_1", "sphere of radius 0"}},
      {kUrdf,
       kCylinder,
       collision("<box size='0.1 0 0.1'/>"),
       {"link leg_0_1", "box without size"}},
      {kUrdf,
       kCylinder,
       collision("<mesh filename='package://a/b.stl'/>"),
       {"link leg_0_1", "mesh", "box, a sphere or a cylinder"}},
      {kUrdf, kCylinder, "<collision/>", {"leg_0_1"}},
      {kUrdf, "<link name=\"leg_0_1\">", "<link name=\"elsewhere\">", {"leg_0_1", "not found"}},
      {kUrdf, "<link name=\"leg_0_1\">", "<link name=\"leg_0_2\">", {"leg_0_2", "not unique"}},
      {kUrdf,
       "<collision>\n      <geometry><box size=\"0.24 0.20 0.04\"/></geometry>\n    </collision>",
       "",
       {"link base_link", "no collision shape"}},
  };
  for (const Case& c : cases) expectComplaint(c);
}

TEST(ImpossibleRobot, JointThatIsNoServoIsNamed) {
  const std::vector<Case> cases = {
      {kUrdf,
       "body_leg_0\" type=\"revolute",
       "body_leg_0\" type=\"prismatic",
       {"joint body_leg_0 is prismatic"}},
      {kUrdf,
       "body_leg_0\" type=\"revolute",
       "body_leg_0\" type=\"fixed",
       {"joint body_leg_0 is fixed", "revolute"}},
      {kUrdf, "body_leg_0\" type=\"revolute", "body_leg_0\" type=\"hinge", {"body_leg_0", "hinge"}},
      {kUrdf,
       "base_body\" type=\"fixed",
       "base_body\" type=\"floating",
       {"joint base_body moves but is in no leg"}},
      {kUrdf, kLimit, "", {"body_leg_0", "limit"}},
      {kUrdf,
       kLimit,
       "<limit effort='1' velocity='1'/>",
       {"joint body_leg_0 has no lower and upper"}},
      {kUrdf,
       kLimit,
       "<limit lower='1' upper='-1' effort='1' velocity='1'/>",
       {"joint body_leg_0", "1 .. -1 rad", "lower below upper"}},
      {kUrdf,
       kLimit,
       "<limit lower='4' upper='5' effort='1' velocity='1'/>",
       {"joint body_leg_0", "4 .. 5 rad", "-pi .. pi"}},
      {kUrdf,
       kLimit,
       "<limit lower='-1' upper='1' effort='0' velocity='1'/>",
       {"joint body_leg_0", "effort 0 N m"}},
      {kUrdf,
       kLimit,
       "<limit lower='-1' upper='1' effort='1' velocity='-1'/>",
       {"joint body_leg_0", "velocity -1 rad/s"}},
      {kUrdf, kLimit, "<limit lower='-1' upper='1' effort='much' velocity='1'/>", {"body_leg_0"}},
      {kUrdf,
       kLimit,
       std::string(kLimit) + "<mimic joint='body_leg_1'/>",
       {"joint body_leg_0 mimics another joint"}},
      {kUrdf,
       "<axis xyz=\"0 0 1\"/>",
       "<axis xyz=\"0 0 0\"/>",
       {"joint body_leg_0 has a zero axis"}},
      {kUrdf, "<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 0\"/>", {"body_leg_0"}},
      {kUrdf, "<child link=\"leg_0_1\"/>", "<child link=\"leg_0_9\"/>", {"leg_0_9"}},
  };
  for (const Case& c : cases) expectComplaint(c);
}

TEST(ImpossibleRobot, GaitOutsideTheLimitsIsNamed) {
  const std::string upper_0 = "0.392699 rad";
  const std::vector<Case> cases = {
      {kUrdf,
       kLimit,
       "<limit lower='-0.3' upper='0.5' effort='1' velocity='1'/>",
       {"joint body_leg_0 moves between -0.392699 and " + upper_0, "limits -0.3 .. 0.5 rad"}},
      {kYaml,
       "neutral_rad: 0.0, amplitude_rad: 0.7",
       "neutral_rad: 1.6, amplitude_rad: 0.7",
       {"joint leg_0_1_2 moves between 0.814602 and 2.3854 rad",
        "The same is true of joints leg_1_1_2, leg_2_1_2, leg_3_1_2, leg_4_1_2 and leg_5_1_2."}},
      {kYaml,
       "amplitude_rad: -0.7853981633974483",
       "amplitude_rad: -1.6",
       {"joint leg_0_2_3 moves between -1.6 and 1.6 rad", "leg_5_2_3"}},
  };
  for (const Case& c : cases) expectComplaint(c);
}

TEST(ImpossibleRobot, LegsThatDoNotMatchTheUrdfAreNamed) {
  const std::string left_rear = "[body_leg_0, leg_0_1_2, leg_0_2_3]";
  const std::vector<Case> cases = {
      {kYaml,
       "[body_leg_0,",
       "[body_leg_00,",
       {"r.yaml: leg left_rear names joint body_leg_00, which r.urdf does not have",
        "did you mean body_leg_0?"}},
      {kYaml, "[body_leg_0,", "[body_leg_1,", {"joint body_leg_1 a second time"}},
      {kYaml,
       left_rear,
       "[leg_0_1_2, body_leg_0, leg_0_2_3]",
       {"joint leg_0_1_2 hangs on link leg_0_1, which is not part of base_link",
        "from the base outwards"}},
      {kYaml, left_rear, "[body_leg_0, leg_0_1_2]", {"2 joints", "3 entries"}},
      {kYaml, left_rear, "[]", {"legs[0].joints should be a list of at least one element"}},
      {kYaml, left_rear, "[body_leg_0, leg_0_1_2, [leg_0_2_3]]", {"legs[0].joints[2]"}},
      {kYaml,
       "base_link: base_link",
       "base_link: bodi",
       {"base_link is bodi, which r.urdf does not have; did you mean body?"}},
      {kYaml,
       "base_link: base_link",
       "base_link: leg_0_1",
       {"base_link is leg_0_1, but it hangs on link body by joint body_leg_0",
        "the root link of the URDF is base_link"}},
      {kYaml, "base_link: base_link", "base_link: base_link\nforward: z", {"forward is \"z\""}},
      {kYaml,
       "  - name: right_rear\n    joints: [body_leg_5, leg_5_1_2, leg_5_2_3]\n",
       "",
       {"joint body_leg_5 moves but is in no leg of r.yaml", "joints leg_5_1_2 and leg_5_2_3"}},
      {kYaml, "name: left_rear", "name: left_middle", {"left_middle a second time"}},
  };
  for (const Case& c : cases) expectComplaint(c);
}

TEST(ImpossibleRobot, KeyThatIsWrongIsNamedWithItsLine) {
  const std::vector<Case> cases = {
      {kYaml,
       "gain_per_s:",
       "gian_per_s:",
       {"servo.gain_per_s is missing", "servo.gian_per_s is not a known key",
        "did you mean gain_per_s?", "r.yaml: line 45: "}},
      {kYaml,
       "friction: 0.9",
       "friction: 0.9\n  frixion: 1.0",
       {"contact.frixion", "did you mean friction?"}},
      {kYaml, "friction: 0.9", "friction: -0.1", {"contact.friction", "from 0 to 10, found -0.1"}},
      {kYaml, "friction: 0.9", "friction: \"0.9\"", {"contact.friction", "without quotes"}},
      {kYaml, "friction: 0.9", "friction: high", {"contact.friction", "found \"high\""}},
      {kYaml, "friction: 0.9", "friction: 0,9", {"contact.friction", "found \"0,9\""}},
      {kYaml, "friction: 0.9", "friction: .nan", {"contact.friction", "found \".nan\""}},
      {kYaml, "friction: 0.9", "friction: .inf", {"contact.friction"}},
      {kYaml, "friction: 0.9", "friction: 1.0e999", {"contact.friction"}},
      {kYaml, "friction: 0.9", "friction:", {"contact.friction", "found nothing"}},
      {kYaml, "friction: 0.9", "friction: [0.9]", {"contact.friction", "found a list"}},
      {kYaml,
       "friction: 0.9",
       "friction: 0.9\n  friction: 0.8",
       {"contact.friction is there twice"}},
      {kYaml, "dead_zone_rad_per_s: 1.0e-5", "", {"servo.dead_zone_rad_per_s is missing"}},
      {kYaml, "signal: 1", "signal: 5", {"gait[0].signal", "from 1 to 4, found 5"}},
      {kYaml, "signal: 1", "signal: 1.5", {"gait[0].signal should be a whole number"}},
      {kYaml, "signal: 1,", "", {"gait[0].signal is missing"}},
      {kYaml, "name: hexapod", "name: [hexapod]", {"name should be a text"}},
      {kYaml, "name: hexapod", "", {"name is missing; expected a text"}},
      {kYaml, "servo:", "servo: 3\nservos:", {"servo should be a mapping", "found \"3\""}},
      {kYaml, "legs:", "legs: {}\nlags:", {"legs should be a list", "did you mean legs?"}},
  };
  for (const Case& c : cases) expectComplaint(c);
}

TEST(ImpossibleRobot, XacroIsToldFromUrdf) {
  const std::string urdf = "<robot xmlns:xacro='http://ros.org/wiki/xacro'><xacro:leg/></robot>";
  EXPECT_NE(complaint(urdf, contentOf(kYamlFile)).find("r.urdf: is xacro, not URDF"),
            std::string::npos);
}

TEST(ImpossibleRobot, OneFaultIsToldOnceAndWithoutItsConsequences) {
  const std::string urdf = replaced(contentOf(kUrdfFile), kCoxaMass, "<mass value=\"-1\"/>");
  EXPECT_EQ(complaint(urdf, contentOf(kYamlFile)),
            "r.urdf: link leg_0_1 has mass -1 kg; expected 0 or more.");
}

TEST(ImpossibleRobot, EveryProblemIsToldAtOnce) {
  std::string urdf =
      replaced(contentOf(kUrdfFile), "<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 0 0\"/>");
  urdf = replaced(urdf, kCoxaMass, "<mass value=\"-1\"/>");
  const std::string yaml = replaced(contentOf(kYamlFile), "leg_5_2_3]", "leg_5_2_33]");
  const std::string said = complaint(urdf, yaml);
  for (const char* part : {"link leg_0_1", "joint body_leg_0 has a zero axis", "leg_5_2_33"}) {
    EXPECT_NE(said.find(part), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace hexapod
