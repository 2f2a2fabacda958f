#include "common/random.h"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

namespace hexapod {
namespace {

TEST(Random, IsTheStandardsMersenneTwister) {
  // [rand.predef]: the 10000th output of a default-constructed mt19937_64 (seed 5489).
  Random random(5489);
  for (int i = 0; i < 9999; ++i) random.bits();
  EXPECT_EQ(random.bits(), 9981545732273789042ull);
}

TEST(Random, ContinuesFromItsState) {
  Random random(7);
  random.uniform();
  Random restored = Random::fromState(random.state());
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(restored.bits(), random.bits());
}

TEST(Random, RefusesAStateThatIsNone) {
  EXPECT_THROW(Random::fromState("seven"), std::invalid_argument);
  EXPECT_THROW(Random::fromState(""), std::invalid_argument);
}

TEST(Random, BelowStaysBelowAndReachesEveryValueAboutEquallyOften) {
  Random random(1);
  std::array<int, 5> counts{};
  for (int i = 0; i < 50000; ++i) ++counts.at(random.below(5));
  for (const int count : counts) EXPECT_NEAR(count, 10000, 400);  // over 4 standard deviations
}

TEST(Random, UniformStaysInItsInterval) {
  Random random(2);
  for (int i = 0; i < 10000; ++i) {
    const double value = random.uniform(-2.0, 3.0);
    ASSERT_GE(value, -2.0);
    ASSERT_LT(value, 3.0);
  }
}

}  // namespace
}  // namespace hexapod
