#include <gtest/gtest.h>

#include <cmath>

#include "ros_interface/display/drawable.h"
#include "ros_interface/display/plan_markers.h"
#include "ros_interface/display/repertoire_markers.h"

namespace hexapod {
namespace {

using visualization_msgs::Marker;

TEST(RepertoireMarkers, AreThreeListsWhateverTheNumberOfEntries) {
  Repertoire repertoire;
  for (const std::size_t count : {0u, 1u, 500u}) {
    repertoire.entries.assign(count, Entry());
    const auto array = repertoireMarkers(repertoire, "odom");
    ASSERT_EQ(array.markers.size(), 3u);
    expectDrawable(array);
    EXPECT_EQ(array.markers[0].points.size(), 6u * count) << "two triangles each";
    EXPECT_EQ(array.markers[2].points.size(), 6u * count) << "two dashes each";
  }
}

TEST(RepertoireMarkers, OfManyEntriesAreOfHalfAsManyTriangles) {
  Repertoire repertoire;
  repertoire.entries.assign(2001, Entry());
  const auto array = repertoireMarkers(repertoire, "odom");
  expectDrawable(array);
  EXPECT_EQ(array.markers[0].points.size(), 3u * 2001);
  EXPECT_EQ(array.markers[0].colors.size(), 2001u);
  EXPECT_EQ(array.markers[1].points.size(), 3u * 2001);
  EXPECT_EQ(array.markers[2].points.size(), 3u * 2001);
}

TEST(RepertoireMarkers, ShowWhatFellInGrey) {
  Repertoire repertoire;
  repertoire.entries.assign(2, Entry());
  repertoire.entries[1].execution = Execution{{0.1, 0.0, 0.0}, 0.0, 0.0, 8, 3};
  const auto points = repertoireMarkers(repertoire, "odom").markers[0];
  EXPECT_GT(points.colors[0].g, points.colors[0].r);
  EXPECT_EQ(points.colors[2].r, points.colors[2].g) << "the first triangle of the second";
  EXPECT_EQ(points.colors[2].g, points.colors[2].b);
}

TEST(RepertoireMarkers, AreSmallerWhereThereAreManySoThatNoneHidesTheOthers) {
  const auto widthOfDisc = [](std::size_t count) {
    Repertoire repertoire;
    repertoire.entries.assign(count, Entry());
    const auto corners = repertoireMarkers(repertoire, "odom").markers[0].points;
    return corners[0].x - corners[1].x;
  };
  EXPECT_EQ(widthOfDisc(1), widthOfDisc(1999));
  EXPECT_NEAR(widthOfDisc(7999), 0.5 * widthOfDisc(1), 1e-12);
}

double brightness(const std_msgs::ColorRGBA& color) {
  return 0.3 * color.r + 0.6 * color.g + 0.1 * color.b;
}

TEST(ErrorColor, GetsDarkerUntilTenDegreesForThoseWhoDoNotSeeColours) {
  constexpr double kDegree = M_PI / 180.0;
  for (int error = 0; error < 10; ++error) {
    EXPECT_GT(brightness(errorColor(error * kDegree)),
              brightness(errorColor((error + 1) * kDegree)))
        << error;
  }
  EXPECT_EQ(errorColor(10.0 * kDegree), errorColor(M_PI));
  EXPECT_EQ(errorColor(-3.0 * kDegree), errorColor(3.0 * kDegree));
}

TEST(PlanMarkers, AreDrawableBeforeDuringAndAfterAWalk) {
  PlanPicture picture;
  picture.frame = "odom";
  expectDrawable(planMarkers(picture));
  picture.path = {{0, 0, 0}};
  expectDrawable(planMarkers(picture));
  picture.path.push_back({0.1, 0, 0});
  picture.stops = {{0.1, 0, 0}};
  picture.walked = {{0, 0, 0}};
  expectDrawable(planMarkers(picture));
  picture.walked.push_back({0.1, 0, 0});
  picture.misses = {{{0.11, 0, 0}, {0.1, 0, 0}}};
  expectDrawable(planMarkers(picture));
}

std::vector<std::string> textsOf(const visualization_msgs::MarkerArray& array) {
  std::vector<std::string> texts;
  for (const Marker& marker : array.markers) {
    if (marker.type == Marker::TEXT_VIEW_FACING && marker.action == Marker::ADD)
      texts.push_back(marker.text);
  }
  return texts;
}

TEST(PlanMarkers, NumberTheMovesOnFromThoseWalked) {
  PlanPicture picture;
  picture.frame = "odom";
  picture.stops = {{0.1, 0, 0}, {0.2, 0, 0}};
  EXPECT_EQ(textsOf(planMarkers(picture)), (std::vector<std::string>{"1", "2"}));
  picture.walked = {{-0.2, 0, 0}, {-0.1, 0, 0}, {0, 0, 0}};
  EXPECT_EQ(textsOf(planMarkers(picture)), (std::vector<std::string>{"3", "4"}));
  EXPECT_EQ(planMarkers(picture).markers.front().action, Marker::DELETEALL) << "of a longer plan";
}

TEST(PlanMarkers, LeadFromThePredictedToTheReachedPose) {
  PlanPicture picture;
  picture.frame = "odom";
  picture.misses = {{{0.1, 0.2, 0}, {0.3, 0.4, 0}}};
  for (const Marker& marker : planMarkers(picture).markers) {
    if (marker.ns != "misses" || marker.type != Marker::LINE_LIST) continue;
    ASSERT_EQ(marker.points.size(), 2u);
    EXPECT_EQ(marker.points[0].y, 0.2);
    EXPECT_EQ(marker.points[1].y, 0.4);
    return;
  }
  FAIL() << "no line";
}

TEST(FootprintMarker, IsTheRimOfAllDiscsTogether) {
  const auto at = [](const geometry_msgs::Point& point, double x_m) {
    return std::hypot(point.x - x_m, point.y);
  };
  const Footprint footprint{{{0.1, 0.0, 0.2}, {-0.1, 0.0, 0.2}}};
  const Marker rim = footprintMarker(footprint, "base_footprint");
  EXPECT_TRUE(rim.frame_locked);
  EXPECT_GT(rim.points.size(), 72u);
  EXPECT_LT(rim.points.size(), 2u * 2u * 72u) << "without what lies within the other disc";
  for (const geometry_msgs::Point& point : rim.points) {
    EXPECT_GE(std::min(at(point, 0.1), at(point, -0.1)), 0.2 - 1e-9);
    EXPECT_NEAR(std::min(at(point, 0.1), at(point, -0.1)), 0.2, 1e-9);
  }
  EXPECT_EQ(footprintMarker({}, "base_footprint").action, Marker::DELETE);
}

TEST(RefusedMarkers, TellTheReasonInShortLinesAndTheNearestPose) {
  RefusedGoal refused{
      "odom",
      {3.0, 1.0, 0.5},
      0.03,
      std::string(20, 'a') + " " + std::string(20, 'b') + " " + std::string(20, 'c'),
      std::nullopt};
  expectDrawable(refusedMarkers(refused));
  EXPECT_EQ(textsOf(refusedMarkers(refused)),
            std::vector<std::string>{std::string(20, 'a') + " " + std::string(20, 'b') + "\n" +
                                     std::string(20, 'c')});
  refused.nearest = Pose2{2.0, 1.0, 0.5};
  expectDrawable(refusedMarkers(refused));
  EXPECT_EQ(textsOf(refusedMarkers(refused)).back(), "nearest that can be reached");
}

}  // namespace
}  // namespace hexapod
