#include "common/stratified.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace hexapod {
namespace {

TEST(Stratified, PutsOneValueIntoEachPartOfTheRange) {
  Random random(3);
  std::set<int> parts;
  for (const double value : stratified(50, -1.0, 4.0, random)) {
    parts.insert(static_cast<int>(std::floor((value + 1.0) / 0.1)));
  }
  EXPECT_EQ(parts.size(), 50u);
  EXPECT_EQ(*parts.begin(), 0);
  EXPECT_EQ(*parts.rbegin(), 49);
  EXPECT_TRUE(stratified(0, 0.0, 1.0, random).empty());
}

}  // namespace
}  // namespace hexapod
