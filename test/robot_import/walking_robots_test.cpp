#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "gait/symmetry.h"
#include "learn_and_walk.h"
#include "made_urdf.h"
#include "robot/load_robot.h"
#include "robot_import/import_robot.h"

namespace hexapod {
namespace {

constexpr std::int64_t kEvaluations = 3000;

void expectWalks(const RobotDescription& robot) {
  const Walks walks = learnAndWalk(robot, kEvaluations);
  testing::Test::RecordProperty("entries_" + robot.name, static_cast<int>(walks.entries));
  EXPECT_EQ(walks.reached, walks.goals)
      << robot.name << ": " << walks.entries << " entries, " << walks.falls << " falls";
}

class ShippedRobots : public testing::TestWithParam<std::string> {};

TEST_P(ShippedRobots, LearnAndWalkToFiveGoals) {
  const RobotDescription robot =
      loadRobot("urdf/" + GetParam() + ".urdf", "config/" + GetParam() + ".yaml");
  EXPECT_TRUE(robot.remarks.empty());
  EXPECT_EQ(whyNotMirrored(robot), "");
  expectWalks(robot);
}

INSTANTIATE_TEST_SUITE_P(All, ShippedRobots,
                         testing::Values("round_hexapod", "quadruped", "pentapod"));

RobotDescription imported(const std::string& urdf) {
  ImportRequest request;
  request.urdf_text = urdf;
  request.urdf_name = "given.urdf";
  request.gaits = 100;
  const ImportResult result = importRobot(request);
  EXPECT_EQ(result.to_change, "");
  EXPECT_EQ(result.gaits.engine, "reduced");
  return result.robot;
}

TEST(ImportedRobots, OfRoughFilesWalks) {
  MadeRobot made;
  made.name = "rough";
  made.has_frames = made.has_world = made.has_box_legs = made.y_forward = true;
  made.has_inertias = false;
  made.limit_rad = 10.0;
  expectWalks(imported(hexapodUrdf(made)));
}

TEST(ImportedRobots, OfHalfTheSizeWalks) {
  MadeRobot made;
  made.name = "half";
  made.scale = 0.5;
  expectWalks(imported(hexapodUrdf(made)));
}

TEST(ImportedRobots, OfThreeTimesTheSizeWalks) {
  MadeRobot made;
  made.name = "triple";
  made.scale = 3.0;
  made.has_collisions = false;
  expectWalks(imported(hexapodUrdf(made)));
}

TEST(ImportedRobots, OnFourLegsWalks) {
  MadeRobot made;
  made.name = "four";
  made.effort_nm = 8.0;
  made.has_frames = true;
  expectWalks(imported(quadrupedUrdf(made)));
}

TEST(ImportedRobots, RoundWithADiscWalks) {
  MadeRobot made;
  made.name = "disc";
  made.has_disc_body = true;
  expectWalks(imported(roundUrdf(made, 6, 0.0)));
}

TEST(ImportedRobots, OnEightLegsOfTwoHingesWalks) {
  MadeRobot made;
  made.name = "eight";
  made.effort_nm = 8.0;
  expectWalks(imported(twoHingeUrdf(made, 8)));
}

}  // namespace
}  // namespace hexapod
