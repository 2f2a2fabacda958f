#include "tools/package_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

#include "tools/evolve_options.h"

namespace hexapod {
namespace {

namespace fs = std::filesystem;

TEST(PackageFiles, FindsAPresetByItsNameWithOrWithoutLearn) {
  const std::string folder = packageFolder();
  EXPECT_EQ(fs::path(presetFile(folder, "learn")).filename(), "learn.yaml");
  for (const fs::directory_entry& file : fs::directory_iterator(folder + "/config")) {
    const std::string stem = file.path().stem().string();
    if (stem.rfind("learn_", 0) == 0) {
      EXPECT_EQ(fs::path(presetFile(folder, stem.substr(6))), file.path());
    }
  }
}

TEST(PackageFiles, EveryPresetCanBeLearnedWith) {
  for (const fs::directory_entry& file : fs::directory_iterator(packageFolder() + "/config")) {
    const std::string stem = file.path().stem().string();
    if (stem.rfind("learn", 0) != 0) continue;
    EXPECT_NO_THROW(evolveOptionsFrom({"--file", "a.db", "--preset", stem})) << stem;
  }
}

TEST(PackageFiles, NamesThePresetsThereAre) {
  for (const std::string name : {"lern", "", "../config/learn", "hexapod/../learn"}) {
    try {
      presetFile(packageFolder(), name);
      FAIL() << name;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("there are learn"), std::string::npos)
          << error.what();
    }
  }
}

}  // namespace
}  // namespace hexapod
