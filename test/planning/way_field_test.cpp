#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "made_map.h"
#include "planning/way_search.h"

namespace hexapod {
namespace {

constexpr double kRadius_m = 0.1;

std::shared_ptr<const Obstacles> forASmallDisc(
    const std::function<bool(double x_m, double y_m)>& occupied, double size_m = 8.0) {
  return std::make_shared<const Obstacles>(
      mapOf(occupied, size_m), Footprint{{{0.0, 0.0, kRadius_m}}}, ObstacleOptions{true, 0.0});
}

// A wall across at x = 0, 10 cm thick, from y = -2 m to the upper rim and beyond.
bool wall(double x_m, double y_m) { return std::abs(x_m) < 0.05 && y_m > -2.0; }

TEST(WayField, GoesStraightWhereNothingIsInTheWay) {
  const WayField::Question question{
      forASmallDisc([](double, double) { return false; }), {-1.0, -0.7, 0.0}, {2.0, 1.0, 0.0}};
  const WayField field(question, WayField::Open::kSurely, 8.0);
  const auto way = field.wayFrom(-1.0, -0.7);
  ASSERT_TRUE(way);
  EXPECT_NEAR(way->length_m, std::hypot(3.0, 1.7), 0.05);
  EXPECT_NEAR(way->direction_rad, std::atan2(1.7, 3.0), 0.05);
  EXPECT_NEAR(way->arrival_rad, std::atan2(1.7, 3.0), 0.05);
}

TEST(WayField, GoesAroundTheCornerOfAWall) {
  const WayField::Question question{forASmallDisc(wall), {-2.0, 0.0, 0.0}, {2.0, 0.0, 0.0}};
  const WayField field(question, WayField::Open::kSurely, 8.0);
  const auto way = field.wayFrom(-2.0, 0.0);
  ASSERT_TRUE(way);
  // Down below the end of the wall at (0, -2 m) and up again.
  EXPECT_NEAR(way->length_m, 2.0 * std::hypot(2.0, 2.0 + kRadius_m), 0.25);
  EXPECT_NEAR(way->direction_rad, -M_PI / 4.0, 0.1);
  EXPECT_NEAR(way->arrival_rad, M_PI / 4.0, 0.1);
}

TEST(WayField, IsNeverLongerThanTheShortestPathWhereItBounds) {
  const WayField::Question question{forASmallDisc(wall), {-2.0, 0.0, 0.0}, {2.0, 0.0, 0.0}};
  const WayField field(question, WayField::Open::kPossibly, 8.0);
  for (int column = -20; column < -2; ++column) {
    for (int row = -20; row < 5; ++row) {
      const double x = 0.1 * column;
      const double y = 0.1 * row;
      // Over the lower corners of the wall, at x = -0.05 m and 0.05 m, as if the disc were a point:
      // shorter than any path of the disc.
      const double shortest = std::hypot(x + 0.05, y + 2.0) + 0.1 + std::hypot(2.0 - 0.05, 2.0);
      EXPECT_LE(field.atLeast_m(x, y), shortest + 2.0 * kRadius_m);
      EXPECT_GE(field.atLeast_m(x, y), 0.85 * shortest - 0.3);
    }
  }
}

TEST(WayField, SeesThatAWayIsBlockedAndWhatIsNearestThen) {
  const auto ring = [](double x_m, double y_m) {
    const double far_m = std::hypot(x_m - 2.0, y_m);
    return far_m > 1.0 && far_m < 1.2;
  };
  const WayField::Question question{forASmallDisc(ring), {-2.0, 0.0, 0.0}, {2.0, 0.0, 0.5}};
  const WaySearch search = findWays(question);
  EXPECT_TRUE(search.blocked);
  const auto nearest = nearestFreePose(question);
  ASSERT_TRUE(nearest);
  EXPECT_NEAR(distance(*nearest, question.world_from_goal), 1.2 + kRadius_m, 0.12);
  EXPECT_EQ(nearest->yaw_rad, 0.5);
}

TEST(WayField, FindsTheWayAroundTheRimOfAMapWhenBeyondIsFree) {
  const auto across = [](double x_m, double) { return std::abs(x_m) < 0.1; };
  const WayField::Question question{forASmallDisc(across, 2.0), {-0.8, 0.0, 0.0}, {0.8, 0.0, 0.0}};
  EXPECT_FALSE(findWays(question).blocked);
}

TEST(WayField, ThatIsStoppedProvesNothing) {
  const auto ring = [](double x_m, double y_m) {
    const double far_m = std::hypot(x_m, y_m);
    return far_m > 3.0 && far_m < 3.2;
  };
  WayField::Question question{forASmallDisc(ring), {-3.6, 0.0, 0.0}, {0.0, 0.0, 0.0}};
  EXPECT_TRUE(findWays(question).blocked);
  question.stop = [] { return true; };
  const WaySearch search = findWays(question);
  EXPECT_TRUE(search.cut_short);
  EXPECT_FALSE(search.blocked);
  EXPECT_FALSE(search.ways);
}

TEST(WayField, AnswersForTheSameGoalAndObstaclesOnly) {
  WayField::Question question{forASmallDisc(wall), {-2.0, 0.0, 0.0}, {2.0, 0.0, 0.0}};
  const WayField field(question, WayField::Open::kSurely, 8.0);
  question.world_from_start = {-1.5, -0.2, 1.0};
  EXPECT_TRUE(field.answers(question));
  WayField::Question other = question;
  other.world_from_goal.x_m += 0.01;
  EXPECT_FALSE(field.answers(other));
  other = question;
  other.obstacles = forASmallDisc(wall);
  EXPECT_FALSE(field.answers(other));
}

}  // namespace
}  // namespace hexapod
