#include "execution/joint_matcher.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace hexapod {
namespace {

const std::vector<std::string> kLeg = {"hip", "knee", "ankle"};

TEST(JointMatcher, OrdersByName) {
  JointMatcher matcher(kLeg);
  ASSERT_TRUE(matcher.match({"ankle", "hip", "knee"}, {3.0, 1.0, 2.0}));
  EXPECT_EQ(matcher.values(), (std::vector<double>{1.0, 2.0, 3.0}));
}

TEST(JointMatcher, SaysWhatIsWrongAndKeepsTheLastGoodValues) {
  JointMatcher matcher(kLeg);
  ASSERT_TRUE(matcher.match(kLeg, {1.0, 2.0, 3.0}));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const struct {
    std::vector<std::string> names;
    std::vector<double> values;
    std::string says;
  } cases[] = {
      {{}, {}, "'hip' is missing"},
      {{"hip", "knee"}, {7.0, 7.0}, "'ankle' is missing"},
      {{"hip", "knee", "knee", "ankle"}, {7.0, 7.0, 7.0, 7.0}, "'knee' occurs twice"},
      {{"hip", "knee", "toe"}, {7.0, 7.0, 7.0}, "'toe' is not one"},
      {{"hip", "knee", "ankle"}, {7.0, nan, 7.0}, "'knee' is not a finite"},
      {{"hip", "knee", "ankle"}, {7.0, 7.0}, "3 names and 2 positions"},
  };
  for (const auto& c : cases) {
    EXPECT_FALSE(matcher.match(c.names, c.values)) << c.says;
    EXPECT_NE(matcher.problem().find(c.says), std::string::npos) << matcher.problem();
    EXPECT_EQ(matcher.values(), (std::vector<double>{1.0, 2.0, 3.0}));
  }
}

TEST(JointMatcher, WantsUniqueNames) {
  EXPECT_THROW(JointMatcher({"hip", "hip"}), std::invalid_argument);
}

}  // namespace
}  // namespace hexapod
