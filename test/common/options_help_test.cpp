#include "common/options_help.h"

#include <gtest/gtest.h>

#include <sstream>

namespace hexapod {
namespace {

TEST(OptionsHelp, HasNameValueRangeAndMeaningInEightyColumns) {
  double way_m = 0.25;
  std::string file;
  const std::string help = helpOn(
      "usage: way [--name value]\n\nA word and another. "
      "More of them than a line of eighty columns can have,\nand more.\n\n  way --file a\n",
      {option("way_m", way_m, "m", "How far `it` goes.", 0.0, 1.0),
       option("file", file,
              "A name " + std::string(30, 'x') + " that goes on and on for longer " +
                  "than a line of eighty columns can be.")});
  EXPECT_EQ(help.substr(0, help.find("  --file  ")),
            "usage: way [--name value]\n\nA word and another. More of them than a line of eighty "
            "columns can have, and\nmore.\n\n  way --file a\n\n"
            "  --way_m  [0.25]  0 .. 1 m\n      How far it goes.\n");
  EXPECT_NE(help.find("  --file  [none]\n"), std::string::npos);
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80u) << line;
}

}  // namespace
}  // namespace hexapod
