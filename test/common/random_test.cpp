#include "common/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
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

TEST(Random, NormalHasMeanZeroAndDeviationOne) {
  Random random(3);
  double sum = 0.0, squares = 0.0;
  int beyond_two = 0;
  constexpr int kCount = 100000;
  for (int i = 0; i < kCount; ++i) {
    const double value = random.normal();
    sum += value;
    squares += value * value;
    beyond_two += std::abs(value) > 2.0;
  }
  EXPECT_NEAR(sum / kCount, 0.0, 0.015);  // over 4 standard deviations
  EXPECT_NEAR(squares / kCount, 1.0, 0.02);
  EXPECT_NEAR(beyond_two, 0.0455 * kCount, 300);
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
