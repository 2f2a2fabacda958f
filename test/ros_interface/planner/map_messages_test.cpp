#include "ros_interface/planner/map_messages.h"

#include <gtest/gtest.h>

#include <limits>

namespace hexapod {
namespace {

/// 4 x 3 cells, all free.
nav_msgs::OccupancyGrid gridMessage() {
  nav_msgs::OccupancyGrid message;
  message.header.frame_id = "/map";
  message.header.stamp = ros::Time(10.0);
  message.info.resolution = 0.1f;
  message.info.width = 4;
  message.info.height = 3;
  message.info.origin.orientation.w = 1.0;
  message.data.assign(12, 0);
  return message;
}

/// 2 x 2 occupied cells whose lower left one is in that column and row.
map_msgs::OccupancyGridUpdate updateAt(int column, int row) {
  map_msgs::OccupancyGridUpdate update;
  update.header.frame_id = "map";
  update.header.stamp = ros::Time(11.0);
  update.x = column;
  update.y = row;
  update.width = 2;
  update.height = 2;
  update.data.assign(4, 100);
  return update;
}

class MapMessages : public testing::Test {
 protected:
  MapMessages() { EXPECT_EQ(readMap(gridMessage(), map_), ""); }

  /// The sentence of a refusal, which leaves the map as it is.
  std::string refusalOf(const map_msgs::OccupancyGridUpdate& update) {
    const std::vector<std::int8_t> before = map_.cells.cells;
    const MapUpdate result = applyUpdate(update, map_);
    EXPECT_FALSE(result.changes);
    EXPECT_EQ(map_.cells.cells, before);
    return result.problem;
  }

  PublishedMap map_;
};

TEST_F(MapMessages, ReadsAMapWithItsFrameWithoutSlash) {
  EXPECT_EQ(map_.frame, "map");
  EXPECT_EQ(map_.cells.columns, 4);
  EXPECT_EQ(map_.cells.rows, 3);
}

TEST_F(MapMessages, AnUpdateReplacesItsRectangleAndNothingElse) {
  const MapUpdate result = applyUpdate(updateAt(2, 1), map_);
  EXPECT_EQ(result.problem, "");
  EXPECT_TRUE(result.changes);
  EXPECT_EQ(map_.cells.cells,
            (std::vector<std::int8_t>{0, 0, 0, 0, 0, 0, 100, 100, 0, 0, 100, 100}));
}

TEST_F(MapMessages, AnUpdateThatSaysWhatIsKnownChangesNothing) {
  applyUpdate(updateAt(2, 1), map_);
  const MapUpdate result = applyUpdate(updateAt(2, 1), map_);
  EXPECT_EQ(result.problem, "");
  EXPECT_FALSE(result.changes);
  map_msgs::OccupancyGridUpdate empty = updateAt(0, 0);
  empty.width = empty.height = 0;
  empty.data.clear();
  EXPECT_EQ(refusalOf(empty), "");
}

TEST_F(MapMessages, AnUpdateOfAnotherFrameIsRefusedNamingBoth) {
  map_msgs::OccupancyGridUpdate update = updateAt(0, 0);
  update.header.frame_id = "odom";
  const std::string problem = refusalOf(update);
  EXPECT_NE(problem.find("'odom'"), std::string::npos) << problem;
  EXPECT_NE(problem.find("'map'"), std::string::npos) << problem;
  update.header.frame_id = "";
  EXPECT_EQ(applyUpdate(update, map_).problem, "") << "it names none: the map's";
}

TEST_F(MapMessages, AnUpdateBeyondTheMapIsRefusedSayingWhere) {
  for (const auto& [column, row] : {std::pair{3, 0}, {0, 2}, {-1, 0}, {0, -1}}) {
    const std::string problem = refusalOf(updateAt(column, row));
    EXPECT_NE(problem.find("column " + std::to_string(column)), std::string::npos) << problem;
    EXPECT_NE(problem.find("4 x 3"), std::string::npos) << problem;
  }
  map_msgs::OccupancyGridUpdate far = updateAt(std::numeric_limits<std::int32_t>::max(), 0);
  EXPECT_NE(refusalOf(far).find("not within"), std::string::npos);
}

TEST_F(MapMessages, AnUpdateWithoutAllOfItsValuesIsRefusedCountingThem) {
  map_msgs::OccupancyGridUpdate update = updateAt(0, 0);
  update.data.pop_back();
  EXPECT_NE(refusalOf(update).find("3 values instead of 4"), std::string::npos);
  update.width = update.height = std::numeric_limits<std::uint32_t>::max();
  EXPECT_NE(refusalOf(update).find("3 values instead of 18446744065119617025"), std::string::npos);
}

// Of the finer map before, say: 2 x 2 cells would mean something else now.
TEST_F(MapMessages, AnUpdateOlderThanTheMapIsRefused) {
  map_msgs::OccupancyGridUpdate update = updateAt(0, 0);
  update.header.stamp = ros::Time(9.0);
  EXPECT_NE(refusalOf(update).find("older"), std::string::npos);
  update.header.stamp = ros::Time();
  EXPECT_EQ(applyUpdate(update, map_).problem, "") << "it does not say when";
}

}  // namespace
}  // namespace hexapod
