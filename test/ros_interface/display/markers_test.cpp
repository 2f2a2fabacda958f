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
  }
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
    return corners[0].x - corners[3].x;
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
}

}  // namespace
}  // namespace hexapod
