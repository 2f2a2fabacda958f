#include "common/text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "common/comma_locale.h"
#include "common/random.h"

namespace hexapod {
namespace {

TEST(Text, ReadsBackTheSameNumberInEveryLocale) {
  const CommaLocale comma;
  Random random(8);
  for (int i = 0; i < 1000; ++i) {
    const double number = random.uniform(-1.0, 1.0) * std::pow(10.0, random.uniform(-12.0, 12.0));
    EXPECT_EQ(doubleFromText(exactText(number)), number);
  }
  EXPECT_EQ(exactText(1234567.25), "1234567.25");
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(doubleFromText(exactText(infinity)), infinity);
  EXPECT_EQ(doubleFromText(exactText(-infinity)), -infinity);
}

TEST(Text, NeedsNoMoreDigitsThanTheNumber) {
  EXPECT_EQ(exactText(0.1), "0.1");
  EXPECT_EQ(exactText(5.0), "5");
  EXPECT_EQ(exactText(0.1 + 0.2), "0.30000000000000004");
}

TEST(Text, RoundsForSentencesInEveryLocale) {
  const CommaLocale comma;
  EXPECT_EQ(numberText(1234.56), "1234.56");
  EXPECT_EQ(numberText(0.78539816, 3), "0.785");
  EXPECT_EQ(fixedText(0.5, 2), "0.50");
  EXPECT_EQ(fixedText(12345.6, 0), "12346");
}

TEST(Text, RefusesWhatIsNotExactlyOneNumber) {
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

TEST(Text, ListsWordsWithCommasBetweenThem) {
  EXPECT_EQ(tableRow({"a", "0.50"}), "| a | 0.50 |\n");
  EXPECT_EQ(listed({}), "");
  EXPECT_EQ(listed({"a"}), "a");
  EXPECT_EQ(listed({"a", "b", "c"}), "a, b, c");
  EXPECT_EQ(separated(" a,b  , c d,, "), (std::vector<std::string>{"a", "b", "c d"}));
  EXPECT_TRUE(separated("").empty());
  EXPECT_EQ(trimmed(" \ta b\r\n"), "a b");
  EXPECT_EQ(trimmed(" \t"), "");
}

TEST(Text, BreaksLinesBetweenWords) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(inLines("one two  three", 7), (Lines{"one two", "three"}));
  EXPECT_EQ(inLines("incomprehensible it is", 5), (Lines{"incomprehensible", "it is"}));
  EXPECT_EQ(inLines("", 5), Lines{""});
}

}  // namespace
}  // namespace hexapod
