#include "ros_interface/display/body_markers.h"

#include <gtest/gtest.h>

#include "self_model/walked_body.h"

namespace hexapod {
namespace {

using visualization_msgs::Marker;

hexapod_repertoire::BodyBelief belief() {
  hexapod_repertoire::BodyBelief belief;
  belief.bodies = {"left_middle: lifted", "left_middle: limp, right_rear: limp", "intact"};
  belief.probabilities = {0.6, 0.3, 0.1};
  belief.sentence = "left_middle: lifted (60 %)";
  return belief;
}

TEST(BodyMarkers, KnowHowLikelyEachLegIsOutOfOrder) {
  EXPECT_NEAR(probabilityOutOfOrder(belief(), "left_middle"), 0.9, 1e-12);
  EXPECT_NEAR(probabilityOutOfOrder(belief(), "right_rear"), 0.3, 1e-12);
  EXPECT_EQ(probabilityOutOfOrder(belief(), "middle"), 0.0);
  EXPECT_EQ(probabilityOutOfOrder(belief(), "left_front"), 0.0);
}

TEST(BodyMarkers, ColourEachLegAndSayWhatIsBelieved) {
  const RobotDescription robot = shippedRobot();
  const auto array = bodyMarkers(robot, belief());
  ASSERT_EQ(array.markers.size(), robot.legs.size() + 1);
  for (std::size_t leg = 0; leg < robot.legs.size(); ++leg) {
    const Marker& line = array.markers[leg];
    EXPECT_EQ(line.id, static_cast<int>(leg));
    EXPECT_EQ(line.header.frame_id, robot.base_link);
    ASSERT_EQ(line.points.size(), robot.legs[leg].segments.size() + 1);
    // A leg leads outwards and down.
    EXPECT_GT(std::hypot(line.points.back().x, line.points.back().y),
              std::hypot(line.points.front().x, line.points.front().y));
    EXPECT_LT(line.points.back().z, line.points.front().z);
    if (robot.legs[leg].name == "left_middle") {
      EXPECT_GT(line.color.r, line.color.g);
    } else {
      EXPECT_GT(line.color.g, line.color.r);
    }
  }
  EXPECT_EQ(array.markers.back().type, Marker::TEXT_VIEW_FACING);
  EXPECT_EQ(array.markers.back().text, "left_middle: lifted (60 %)");
}

}  // namespace
}  // namespace hexapod
