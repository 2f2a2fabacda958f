#include "ros_interface/planner/map_in_use.h"

#include <geometry_msgs/TransformStamped.h>
#include <gtest/gtest.h>

#include "ros_interface/common/conversions.h"

namespace hexapod {
namespace {

/// 2 m x 2 m around `origin`, of which the right half is occupied.
nav_msgs::OccupancyGrid halfOccupied(const Pose2& origin, const std::string& frame) {
  nav_msgs::OccupancyGrid map;
  map.header.frame_id = frame;
  map.info.resolution = 0.1f;
  map.info.width = 20;
  map.info.height = 20;
  map.info.origin = toPoseMsg(origin * Pose2{-1.0, -1.0, 0.0});
  for (int i = 0; i < 400; ++i) map.data.push_back(i % 20 >= 10 ? 100 : 0);
  return map;
}

class MapInUseTest : public testing::Test {
 protected:
  void place(double x_m, double stamp_s) {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = "odom";
    transform.header.stamp = ros::Time(stamp_s);
    transform.child_frame_id = "map";
    transform.transform.translation.x = x_m;
    transform.transform.rotation.w = 1.0;
    buffer_.setTransform(transform, "test");
  }

  std::shared_ptr<const Obstacles> settled() {
    map_.settle();
    return map_.obstacles();
  }

  PlannerNodeOptions options_;
  tf2::BufferCore buffer_;
  MapInUse map_{options_, buffer_, Footprint{{{0.0, 0.0, 0.2}}}};
};

TEST_F(MapInUseTest, ThereIsNoneUntilOneCame) { EXPECT_EQ(map_.obstacles(), nullptr); }

TEST_F(MapInUseTest, StandsWhereItsOriginSaysTurnedAsThatIs) {
  // A quarter turn to the left: occupied is what lies beyond y = 3 m.
  EXPECT_EQ(map_.take(halfOccupied({5.0, 3.0, M_PI / 2.0}, "odom")), "");
  const auto obstacles = settled();
  ASSERT_TRUE(obstacles);
  EXPECT_TRUE(obstacles->isFree({5.0, 2.7, 0.0}));
  EXPECT_FALSE(obstacles->isFree({5.0, 2.8, 0.0}));
  EXPECT_EQ(map_.obstacles(), obstacles) << "another object although nothing has changed";
}

TEST_F(MapInUseTest, StaysTheSameWhenTheSameComesAgainAndNotWhenOneCellDiffers) {
  nav_msgs::OccupancyGrid map = halfOccupied({}, "odom");
  EXPECT_EQ(map_.take(map), "");
  const auto first = settled();
  map.header.stamp = ros::Time(5.0);
  EXPECT_EQ(map_.take(map), "");
  EXPECT_EQ(settled(), first);
  map.data[0] = 100;
  EXPECT_EQ(map_.take(map), "");
  const auto second = settled();
  EXPECT_NE(second, first);
  map.info.origin.position.x += 0.5;
  EXPECT_EQ(map_.take(map), "");
  EXPECT_NE(settled(), second);
}

TEST_F(MapInUseTest, FollowsItsFrameInTheGlobalOne) {
  place(10.0, 1.0);
  EXPECT_EQ(map_.take(halfOccupied({0.0, 0.0, 0.0}, "map")), "");
  const auto before = settled();
  ASSERT_TRUE(before);
  EXPECT_TRUE(before->isFree({9.5, 0.0, 0.0}));
  EXPECT_FALSE(before->isFree({10.0, 0.0, 0.0}));
  place(10.4, 2.0);
  EXPECT_TRUE(map_.obstacles()->isFree({10.0, 0.0, 0.0}));
}

TEST_F(MapInUseTest, WaitsUntilTfTellsWhereItsFrameIs) {
  EXPECT_EQ(map_.take(halfOccupied({}, "odom")), "");
  const auto before = settled();
  EXPECT_EQ(map_.problem(), "");
  EXPECT_EQ(map_.take(halfOccupied({}, "map")), "");
  EXPECT_EQ(settled(), before);
  EXPECT_NE(map_.problem().find("frame of the map, map, lies in odom"), std::string::npos);
  place(10.0, 1.0);
  EXPECT_EQ(map_.problem(), "");
  EXPECT_FALSE(map_.obstacles()->isFree({10.0, 0.0, 0.0}));
  EXPECT_TRUE(map_.obstacles()->isFree({0.5, 0.0, 0.0}));
}

TEST_F(MapInUseTest, RefusesWhatIsNoMapAndKeepsTheOneItHas) {
  EXPECT_EQ(map_.take(halfOccupied({}, "odom")), "");
  const auto kept = settled();
  nav_msgs::OccupancyGrid bad = halfOccupied({}, "odom");
  bad.data.pop_back();
  EXPECT_NE(map_.take(bad).find("399 values"), std::string::npos);
  bad = halfOccupied({}, "odom");
  bad.info.origin.orientation.w = 0.0;
  EXPECT_NE(map_.take(bad).find("origin"), std::string::npos);
  EXPECT_EQ(settled(), kept);
}

TEST_F(MapInUseTest, IsBroughtUpToDateInPart) {
  map_msgs::OccupancyGridUpdate update;
  update.header.frame_id = "odom";
  update.x = 10;
  update.width = 10;
  update.height = 20;
  update.data.assign(200, 0);
  EXPECT_NE(map_.take(update).find("no map has come"), std::string::npos);
  EXPECT_EQ(map_.take(halfOccupied({}, "odom")), "");
  EXPECT_FALSE(settled()->isFree({0.5, 0.0, 0.0}));
  EXPECT_EQ(map_.take(update), "");
  const auto freed = settled();
  EXPECT_TRUE(freed->isFree({0.5, 0.0, 0.0}));
  EXPECT_EQ(map_.take(update), "");
  EXPECT_EQ(settled(), freed) << "another object although nothing has changed";
}

TEST_F(MapInUseTest, ANewMapOfAnotherResolutionReplacesAllOfTheOneBefore) {
  EXPECT_EQ(map_.take(halfOccupied({}, "odom")), "");
  nav_msgs::OccupancyGrid coarse = halfOccupied({}, "odom");
  coarse.info.resolution = 1.0f;
  coarse.info.width = coarse.info.height = 2;
  coarse.data = {100, 0, 100, 0};
  EXPECT_EQ(map_.take(coarse), "");
  EXPECT_TRUE(settled()->isFree({0.5, 0.0, 0.0}));
  EXPECT_FALSE(settled()->isFree({-0.5, 0.0, 0.0}));
  map_msgs::OccupancyGridUpdate fine;
  fine.header.frame_id = "odom";
  fine.width = fine.height = 20;
  fine.data.assign(400, 100);
  EXPECT_NE(map_.take(fine).find("not within the map of 2 x 2"), std::string::npos);
}

TEST_F(MapInUseTest, NeedsToKnowTheRobot) {
  MapInUse nobody(options_, buffer_, std::nullopt);
  EXPECT_NE(nobody.take(halfOccupied({}, "odom")).find("footprint_radius_m"), std::string::npos);
  EXPECT_EQ(nobody.obstacles(), nullptr);
  PlannerNodeOptions options;
  options.footprint_radius_m = 0.3;
  MapInUse told(options, buffer_, Footprint{{{0.0, 0.0, 0.2}}});
  EXPECT_EQ(told.footprint()->outer_m(), 0.3) << "shown is what is kept free";
  EXPECT_EQ(told.take(halfOccupied({}, "odom")), "");
  told.settle();
  EXPECT_FALSE(told.obstacles()->isFree({-0.3, 0.0, 0.0}));
  EXPECT_TRUE(told.obstacles()->isFree({-0.36, 0.0, 0.0}));
}

}  // namespace
}  // namespace hexapod
