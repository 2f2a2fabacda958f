#include "planning/obstacles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "common/random.h"
#include "made_map.h"

namespace hexapod {
namespace {

/// Random cells of a small map, a few of them unknown.
OccupancyMap randomMap(Random& random, double share) {
  OccupancyMap map;
  map.resolution_m = 0.1;
  map.columns = 23;
  map.rows = 17;
  for (int i = 0; i < map.columns * map.rows; ++i) {
    const int value = random.chance(share) ? 100 : random.chance(0.02) ? -1 : 0;
    map.cells.push_back(static_cast<std::int8_t>(value));
  }
  return map;
}

/// The oracle: distance from a point of the map to the nearest cell that counts as occupied.
double bruteDistance(const OccupancyMap& map, bool unknown_is_free, double x_m, double y_m) {
  double nearest_m = DistanceField::kFar_m;
  for (int row = -40; row < map.rows + 40; ++row) {
    for (int column = -40; column < map.columns + 40; ++column) {
      const bool inside = row >= 0 && column >= 0 && row < map.rows && column < map.columns;
      const std::int8_t value = inside ? map.at(column, row) : OccupancyMap::kUnknown;
      if (value < 0 ? unknown_is_free : value < OccupancyMap::kOccupied) continue;
      const double side = map.resolution_m;
      const double x = std::clamp(x_m, column * side, (column + 1) * side);
      const double y = std::clamp(y_m, row * side, (row + 1) * side);
      nearest_m = std::min(nearest_m, std::hypot(x - x_m, y - y_m));
    }
  }
  return nearest_m;
}

TEST(DistanceField, BoundsTheDistanceToTheNearestOccupiedCell) {
  Random random(1);
  for (const bool unknown_is_free : {true, false}) {
    for (const double share : {0.002, 0.02, 0.2}) {
      const OccupancyMap map = randomMap(random, share);
      const DistanceField field(map, unknown_is_free);
      for (int i = 0; i < 200; ++i) {
        const double x = random.uniform(-0.5, 2.8);
        const double y = random.uniform(-0.5, 2.2);
        const double exact = bruteDistance(map, unknown_is_free, x, y);
        EXPECT_LE(field.atLeast(x, y), exact + 1e-6) << x << " " << y;
        EXPECT_GE(field.atMost(x, y), exact - 1e-6) << x << " " << y;
        const bool inside = x > 0.0 && y > 0.0 && x < 2.3 && y < 1.7;
        if (inside && exact < DistanceField::kFar_m) {
          EXPECT_NEAR(field.atLeast(x, y), exact, 0.1);
        }
      }
    }
  }
}

TEST(DistanceField, IsExactAtTheCornersOfCells) {
  Random random(2);
  const OccupancyMap map = randomMap(random, 0.02);
  const DistanceField field(map, true);
  for (int row = 0; row <= map.rows; ++row) {
    for (int column = 0; column <= map.columns; ++column) {
      const double x = column * map.resolution_m;
      const double y = row * map.resolution_m;
      EXPECT_NEAR(field.atLeast(x, y), bruteDistance(map, true, x, y), 1e-6);
    }
  }
}

TEST(DistanceField, IsSharpInTheMiddleOfPassagesOfAnyNumberOfCells) {
  for (const double resolution_m : {0.02, 0.05, 0.07, 0.1, 0.25}) {
    for (const int free : {3, 4}) {
      const DistanceField field(passageOf(free, 20, resolution_m), true);
      const double half_m = 0.5 * free * resolution_m;
      for (const double x_m : {7.0, 7.25, 7.5}) {
        EXPECT_NEAR(field.atLeast(x_m * resolution_m, resolution_m + half_m), half_m, 0.005);
      }
    }
  }
}

TEST(DistanceField, OfAnEmptyMapIsFarEverywhere) {
  const DistanceField field(mapOf([](double, double) { return false; }, 1.0), true);
  EXPECT_EQ(field.atLeast(0.5, 0.5), DistanceField::kFar_m);
  EXPECT_EQ(field.atLeast(-7.0, 0.5), DistanceField::kFar_m);
}

TEST(Obstacles, MeasureTheRoomOfAFootprintInATurnedMap) {
  // A wall from x = 1 m on in the map, which stands a quarter turn to the left at (2 m, 3 m).
  OccupancyMap map = mapOf([](double x_m, double) { return x_m > 1.0; }, 4.0);
  map.world_from_map = Pose2{2.0, 3.0, M_PI / 2.0} * map.world_from_map;
  const Footprint longish{{{0.2, 0.0, 0.1}, {-0.2, 0.0, 0.1}}};
  const Obstacles obstacles(map, longish, ObstacleOptions{true, 0.05});
  // In the world the wall begins at y = 4 m; the robot at y = 3.5 m faces it or stands along it.
  EXPECT_NEAR(obstacles.clearance_m({2.0, 3.5, M_PI / 2.0}), 0.5 - 0.2 - 0.15, 0.02);
  EXPECT_NEAR(obstacles.clearance_m({2.0, 3.5, 0.0}), 0.5 - 0.15, 0.02);
  EXPECT_LE(obstacles.clearance_m({2.0, 3.5, 0.0}), 0.5 - 0.15 + 1e-6);
  EXPECT_FALSE(obstacles.isFree({2.0, 3.8, M_PI / 2.0}));
  EXPECT_TRUE(obstacles.isFree({2.0, 3.8, 0.0}));
}

TEST(Obstacles, TakeUnknownCellsAndTheOutsideAsTheOptionSays) {
  OccupancyMap map = mapOf([](double, double) { return false; }, 2.0);
  map.cells[0] = OccupancyMap::kUnknown;
  const Footprint disc{{{0.0, 0.0, 0.1}}};
  const Obstacles open(map, disc, ObstacleOptions{true, 0.0});
  const Obstacles closed(map, disc, ObstacleOptions{false, 0.0});
  for (const Pose2& pose :
       {Pose2{-0.95, -0.95, 0.0}, Pose2{0.95, 0.0, 0.0}, Pose2{5.0, 5.0, 0.0}}) {
    EXPECT_TRUE(open.isFree(pose));
    EXPECT_FALSE(closed.isFree(pose));
  }
  EXPECT_TRUE(closed.isFree({0.0, 0.0, 0.0}));
}

TEST(Obstacles, JudgeAPathBySmallestRoomBetweenItsPoints) {
  // A post of 10 cm beside a straight way of 1 m, of which only the ends are given.
  const auto obstacles = obstaclesOf(
      [](double x_m, double y_m) { return std::abs(x_m) < 0.05 && std::abs(y_m) < 0.05; });
  const MovePath straight = makeMovePath({1.0, 0.0, 0.0}, {{1.0, 0.0, 0.0}});
  EXPECT_FALSE(obstacles->isFree({-0.5, 0.0, 0.0}, straight)) << "through the post";
  EXPECT_FALSE(obstacles->isFree({-0.5, 0.35, 0.0}, straight)) << "grazes it";
  EXPECT_TRUE(obstacles->isFree({-0.5, 1.2, 0.0}, straight));
}

TEST(Obstacles, LetARobotWithinItsMarginLeaveButComeNoNearer) {
  const auto obstacles = obstaclesOf([](double x_m, double) { return x_m > 1.0; });
  const Pose2 start{1.0 - 0.32, 0.0, 0.0};  // a centimetre of three
  const double least_m = obstacles->clearance_m(start);
  EXPECT_LT(least_m, 0.0);
  const auto way = [](double x_m) { return makeMovePath({x_m, 0.0, 0.0}, {{x_m, 0.0, 0.0}}); };
  EXPECT_FALSE(obstacles->isFree(start, way(-0.1)));
  EXPECT_TRUE(obstacles->isFree(start, way(-0.1), least_m));
  EXPECT_FALSE(obstacles->isFree(start, way(0.01), least_m));
}

TEST(Obstacles, RefuseAMapThatIsNoneNamingWhatIsWrong) {
  OccupancyMap map = mapOf([](double, double) { return false; }, 1.0);
  map.cells.pop_back();
  try {
    const Obstacles obstacles(map, Footprint{}, ObstacleOptions{});
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("399 values instead of 400"), std::string::npos)
        << error.what();
  }
}

TEST(MovePath, BendsTheKnownWayToTheExpectedEnd) {
  const std::vector<Pose2> way = {{0.1, 0.05, 0.0}, {0.2, 0.0, 0.2}};
  const MovePath path = makeMovePath({0.3, 0.1, 0.0}, way);
  ASSERT_EQ(path.points.size(), 3u);
  EXPECT_EQ(path.points[1].bulge_m, 0.0);
  // Half of what the end differs by, (0.1 m, 0.1 m, -0.2 rad), at the first point; all at the last.
  EXPECT_NEAR(path.points[1].x_m, 0.15, 1e-12);
  EXPECT_NEAR(path.points[1].y_m, 0.10, 1e-12);
  EXPECT_NEAR(path.points[1].sine, std::sin(-0.1), 1e-12);
  EXPECT_NEAR(path.points[2].x_m, 0.3, 1e-12);
  EXPECT_NEAR(path.points[2].sine, 0.0, 1e-12);
}

TEST(MovePath, OfAnAbsurdlyFarEndHasNoMorePointsThanIsReasonable) {
  EXPECT_LT(makeMovePath({1e6, -1e6, 0.0}, {}).points.size(), 3000u);
}

TEST(MovePath, OfAnUnknownWayIsAnArcWithABulge) {
  const MovePath path = makeMovePath({0.5, 0.0, 0.0}, {});
  ASSERT_GT(path.points.size(), 10u);
  EXPECT_NEAR(path.points[path.points.size() / 2].bulge_m, 0.02 + 0.05, 1e-3);
  EXPECT_EQ(path.points.back().bulge_m, 0.0);
}

}  // namespace
}  // namespace hexapod
