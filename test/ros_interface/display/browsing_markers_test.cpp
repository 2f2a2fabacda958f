#include <gtest/gtest.h>
#include <ros/serialization.h>

#include <cmath>
#include <stdexcept>

#include "execution/shipped_robot.h"
#include "ros_interface/display/drawable.h"
#include "ros_interface/display/entry_markers.h"
#include "ros_interface/display/gait_markers.h"
#include "ros_interface/display/repertoire_markers.h"
#include "ros_interface/display/scene_markers.h"

namespace hexapod {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

const Marker& named(const MarkerArray& array, const std::string& name, int id) {
  for (const Marker& marker : array.markers) {
    if (marker.ns == name && marker.id == id) return marker;
  }
  throw std::out_of_range(name);
}

TEST(SceneMarkers, AreDrawableBeforeAnythingIsLearned) {
  const RobotDescription& robot = shippedRobot();
  const MarkerArray array = sceneMarkers(robot, Repertoire(), "somewhere");
  expectDrawable(array);
  for (const Marker& marker : array.markers) EXPECT_EQ(marker.header.frame_id, "somewhere");
}

TEST(SceneMarkers, OutlineTheRobotToItsFeetAndThePapersRegion) {
  const MarkerArray array = sceneMarkers(shippedRobot(), Repertoire(), "odom");
  double widest_m = 0.0;
  for (const auto& point : named(array, "robot_outline", 0).points) {
    widest_m = std::max(widest_m, std::abs(point.y));
  }
  EXPECT_NEAR(widest_m, 0.25, 0.06);
  double farthest_m = 0.0;
  for (const auto& point : named(array, "region_of_interest", 0).points) {
    farthest_m = std::max(farthest_m, std::hypot(point.x, point.y));
    if (std::hypot(point.x, point.y) < 1e-9) continue;
    EXPECT_LE(std::abs(std::atan2(point.y, std::abs(point.x))), M_PI / 3.0 + 1e-9);
  }
  EXPECT_NEAR(farthest_m, 0.6, 1e-9);
}

TEST(SceneMarkers, TellTheFiguresInWords) {
  Repertoire repertoire;
  repertoire.evaluations = 500;
  repertoire.entries.resize(2);
  repertoire.entries[0].end_pose = {0.3, 0.0, M_PI / 180.0};
  repertoire.entries[1].end_pose = {-0.3, 0.0, 0.0};
  const std::string figures = figuresOf(repertoire, shippedRobot());
  EXPECT_NE(figures.find("2 behaviours of 500 tried"), std::string::npos);
  EXPECT_NE(figures.find("orientation error 0.50 deg"), std::string::npos) << figures;
}

TEST(EntryMarkers, DrawTheEntryFromWhereTheRobotStood) {
  EntryPicture picture;
  picture.frame = "odom";
  picture.start = {1.0, 2.0, M_PI / 2.0};
  picture.entry.id = 12;
  picture.entry.end_pose = {0.4, 0.0, 0.0};
  const MarkerArray array = entryMarkers(picture);
  expectDrawable(array);
  const Marker& arc = named(array, "entry", 0);
  EXPECT_NEAR(arc.points.front().x, 1.0, 1e-9);
  EXPECT_NEAR(arc.points.back().x, 1.0, 1e-9);
  EXPECT_NEAR(arc.points.back().y, 2.4, 1e-9);
  EXPECT_NE(named(array, "entry", 4).text.find("entry 12"), std::string::npos);
  EXPECT_EQ(named(array, "entry", 3).action, Marker::DELETE);
}

TEST(EntryMarkers, TellHowFarTheRobotCameFromThePrediction) {
  EntryPicture picture;
  picture.frame = "odom";
  picture.entry.end_pose = {0.4, 0.0, 0.0};
  picture.reached = Pose2{0.43, 0.04, 2.0 * M_PI / 180.0};
  const MarkerArray array = entryMarkers(picture);
  expectDrawable(array);
  EXPECT_NE(named(array, "entry", 4).text.find("5.0 cm and 2.0 deg"), std::string::npos);
  EXPECT_NEAR(named(array, "entry", 3).pose.position.x, 0.43, 1e-9);
}

TEST(RepertoireMarkers, OfTenThousandEntriesAreLessThanFiveMegabytes) {
  Repertoire repertoire;
  repertoire.entries.resize(10000);
  const MarkerArray array = repertoireMarkers(repertoire, "odom");
  EXPECT_LT(ros::serialization::serializationLength(array), 5'000'000u);
}

TEST(GaitMarkers, HaveABarForEachTimeThatAFootStands) {
  GaitPicture picture;
  picture.title = "entry 3";
  picture.legs = {"left", "right"};
  picture.period_s = 0.5;
  picture.stands = {{true, false}, {true, true}, {false, true}, {true, true}};
  const MarkerArray array = gaitMarkers(picture, "odom", Pose2{1.0, 2.0, 0.0});
  expectDrawable(array);
  // The left foot stands twice, the right one once: two ends each.
  const Marker& bars = named(array, "gait", 0);
  ASSERT_EQ(bars.points.size(), 6u);
  // A quarter of the time is a quarter of the width, to the right.
  const double width_m = bars.points[4].y - bars.points[5].y;
  EXPECT_NEAR(bars.points[0].y - bars.points[1].y, width_m * 2.0 / 3.0, 1e-9);
  EXPECT_DOUBLE_EQ(bars.points[0].y, 2.0);
  EXPECT_LT(bars.points[4].x, bars.points[0].x);
  EXPECT_EQ(named(array, "gait", 1).text, "left");
  EXPECT_NE(named(array, "gait", 3).text.find("2.0 s"), std::string::npos);
}

TEST(GaitMarkers, AreTakenAwayAllOfThem) {
  const RobotDescription& robot = shippedRobot();
  GaitPicture picture;
  for (const Leg& leg : robot.legs) picture.legs.push_back(leg.name);
  const MarkerArray drawn = gaitMarkers(picture, "odom", {});
  const MarkerArray gone = noGaitMarkers(robot.legs.size(), "odom");
  for (const Marker& marker : drawn.markers) {
    EXPECT_EQ(named(gone, marker.ns, marker.id).action, Marker::DELETE);
  }
}

TEST(EntryMarkers, RingAndNameTheNeighbours) {
  EntryPicture picture;
  picture.frame = "odom";
  picture.entry.end_pose = {0.5, 0.0, 0.0};
  Entry neighbour;
  neighbour.id = 12;
  neighbour.end_pose = {0.5, 0.04, 0.16};
  picture.neighbours = {neighbour};
  const MarkerArray array = entryMarkers(picture);
  expectDrawable(array);
  EXPECT_FALSE(named(array, "entry", 5).points.empty());
  EXPECT_NE(named(array, "entry", 4).text.find("12: 4.0 cm"), std::string::npos);
}

}  // namespace
}  // namespace hexapod
