#include "tools/command_line.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace hexapod {
namespace {

struct Options {
  bool quick = false;
  std::int64_t seed = 1;
  std::string folder;

  std::vector<Option> declared() {
    return {option("quick", quick, "Quick."), option("seed", seed, "Seed.", 0, 100),
            option("folder", folder, "Folder.")};
  }
};

std::map<std::string, OptionValue> read(const std::vector<std::string>& words) {
  Options options;
  return valuesFromCommandLine(words, options.declared(), {{"o", "folder"}});
}

TEST(CommandLine, ReadsEveryWayOfWritingAnOption) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--seed", "3", "--quick", "-o", "a"},
        {"--seed=3", "--quick", "true", "--o=a"},
        {"seed:=3", "quick:=true", "folder:=a"}}) {
    const auto values = read(words);
    EXPECT_EQ(std::get<std::int64_t>(values.at("seed")), 3);
    EXPECT_TRUE(std::get<bool>(values.at("quick")));
    EXPECT_EQ(std::get<std::string>(values.at("folder")), "a");
  }
}

TEST(CommandLine, KeepsATextThatLooksLikeANumber) {
  EXPECT_EQ(std::get<std::string>(read({"--folder", "12"}).at("folder")), "12");
}

TEST(CommandLine, KeepsUnknownNamesForTheOptionsToComplainOf) {
  EXPECT_EQ(read({"--sed", "3"}).count("sed"), 1u);
}

TEST(CommandLine, RefusesWhatIsNoOptionHasNoValueOrIsThereTwice) {
  EXPECT_THROW(read({"seed"}), std::invalid_argument);
  EXPECT_THROW(read({""}), std::invalid_argument);
  EXPECT_THROW(read({"--seed"}), std::invalid_argument);
  EXPECT_THROW(read({"--seed", "1", "seed:=2"}), std::invalid_argument);
}

}  // namespace
}  // namespace hexapod
