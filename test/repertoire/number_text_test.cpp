#include "repertoire/number_text.h"

#include <gtest/gtest.h>

#include <limits>

#include "fixtures.h"

namespace hexapod {
namespace {

TEST(NumberText, ReadsBackTheSameNumberInEveryLocale) {
  const CommaLocale comma;
  Random random(8);
  for (int i = 0; i < 1000; ++i) {
    const double number = random.uniform(-1.0, 1.0) * std::pow(10.0, random.uniform(-12.0, 12.0));
    EXPECT_EQ(doubleFromText(toText(number)), number);
  }
  EXPECT_EQ(toText(1234567.25), "1234567.25");
  EXPECT_EQ(doubleFromText(toText(std::numeric_limits<double>::infinity())),
            std::numeric_limits<double>::infinity());
}

TEST(NumberText, RefusesWhatIsNotExactlyOneNumber) {
  for (const char* text : {"", " 1", "1 ", "1,5", "1x", "x", "--1", "1 2"}) {
    EXPECT_FALSE(doubleFromText(text)) << text;
    EXPECT_FALSE(integerFromText(text)) << text;
    EXPECT_FALSE(unsignedFromText(text)) << text;
  }
  EXPECT_FALSE(integerFromText("1.5"));
  EXPECT_FALSE(integerFromText("99999999999999999999"));
  EXPECT_FALSE(unsignedFromText("-1"));
  EXPECT_EQ(unsignedFromText("18446744073709551615"), 18446744073709551615U);
  EXPECT_EQ(integerFromText("-9223372036854775808"), std::numeric_limits<std::int64_t>::min());
}

}  // namespace
}  // namespace hexapod
