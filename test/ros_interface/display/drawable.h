#pragma once

#include <gtest/gtest.h>
#include <visualization_msgs/MarkerArray.h>

#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace hexapod {

/// rviz reports lists without points, lines of one, texts without any and two markers of one name
/// as errors.
inline void expectDrawable(const visualization_msgs::MarkerArray& array) {
  using visualization_msgs::Marker;
  std::set<std::pair<std::string, int>> names;
  for (const Marker& marker : array.markers) {
    EXPECT_TRUE(names.emplace(marker.ns, marker.id).second) << marker.ns << " " << marker.id;
    if (marker.action == Marker::DELETE || marker.action == Marker::DELETEALL) continue;
    if (marker.type == Marker::TEXT_VIEW_FACING) {
      EXPECT_FALSE(marker.text.empty());
      EXPECT_GT(marker.scale.z, 0.0);
      continue;
    }
    EXPECT_GT(marker.scale.x, 0.0) << marker.ns;
    EXPECT_NEAR(std::hypot(marker.pose.orientation.w, marker.pose.orientation.z), 1.0, 1e-12)
        << marker.ns;
    if (marker.type == Marker::ARROW) continue;
    EXPECT_GE(marker.points.size(), marker.type == Marker::LINE_STRIP ? 2u : 1u) << marker.ns;
    const std::size_t corners = marker.type == Marker::TRIANGLE_LIST ? 3u : 1u;
    EXPECT_EQ(marker.points.size() % corners, 0u) << marker.ns;
    EXPECT_TRUE(marker.colors.empty() || marker.colors.size() == marker.points.size() / corners)
        << marker.ns;
  }
}

}  // namespace hexapod
