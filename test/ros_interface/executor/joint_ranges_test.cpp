#include "ros_interface/executor/joint_ranges.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hexapod {
namespace {

JointReadings readings(const std::vector<double>& angles_rad,
                       const std::vector<std::uint64_t>& counts) {
  JointReadings readings(angles_rad.size());
  readings.angles_rad = angles_rad;
  readings.counts = counts;
  return readings;
}

TEST(JointRanges, KeepsHowFarEachJointWasSeenToMoveSinceItBegan) {
  JointRanges ranges(2);
  ranges.add(readings({9.0, 9.0}, {1, 1}));
  ranges.begin();
  ranges.add(readings({0.1, 9.0}, {2, 1}));
  ranges.add(readings({-0.3, 9.0}, {3, 1}));
  EXPECT_EQ(ranges.min_rad()[0], -0.3);
  EXPECT_EQ(ranges.max_rad()[0], 0.1);
  EXPECT_TRUE(std::isnan(ranges.min_rad()[1])) << "read before, and not since";
  EXPECT_TRUE(std::isnan(ranges.max_rad()[1]));
}

}  // namespace
}  // namespace hexapod
