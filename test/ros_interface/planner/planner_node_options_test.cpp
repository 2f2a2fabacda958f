#include "ros_interface/planner/planner_node_options.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace hexapod {
namespace {

TEST(PlannerNodeOptions, RefuseAYawToleranceOfZeroWhereItIsSet) {
  PlannerNodeOptions options;
  EXPECT_NO_THROW(checkOptions(options));
  options.planner.yaw_tolerance_rad = -1.0;
  EXPECT_NO_THROW(checkOptions(options));
  options.planner.yaw_tolerance_rad = 0.0;
  EXPECT_THROW(checkOptions(options), std::invalid_argument);
}

}  // namespace
}  // namespace hexapod
