#include "repertoire/find_repertoire.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "fixtures.h"

namespace hexapod {
namespace {

namespace fs = std::filesystem;

class FindRepertoire : public ::testing::Test {
 protected:
  std::string make(const std::string& name, int age_s) const {
    const fs::path file = folder_.file(name);
    std::ofstream(file) << "anything";
    fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::seconds(age_s));
    return file.string();
  }

  std::string problem(const std::string& named) const {
    try {
      findRepertoire(named, folder());
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }

  std::string folder() const { return folder_.file("."); }

  TemporaryFolder folder_;
};

TEST_F(FindRepertoire, TakesTheOneThatIsNamed) {
  make("hexapod_repertoire.db", 0);
  const std::string mine = make("mine.db", 100);
  EXPECT_EQ(findRepertoire(mine, folder()), mine);
}

TEST_F(FindRepertoire, WithoutANameTakesTheNewestThatLearningLeft) {
  make("hexapod_repertoire.db", 60);
  const std::string newest = make("hexapod_repertoire_demo.db", 30);
  make("hexapod_repertoire_demo.db.png", 10);
  make("another.db", 0);
  fs::create_directory(folder_.file("hexapod_repertoire_folder.db"));
  EXPECT_EQ(findRepertoire("", folder()), newest);
}

TEST_F(FindRepertoire, NamesTheOnesThereAreWhenTheNamedOneIsMissing) {
  const std::string old = make("hexapod_repertoire.db", 60);
  const std::string newest = make("hexapod_repertoire_demo.db", 30);
  EXPECT_EQ(problem("/nowhere/a.db"),
            "There is no repertoire file /nowhere/a.db. There are, the newest first: " + newest +
                ", " + old + ".");
}

TEST_F(FindRepertoire, SaysHowToMakeOneWhenThereIsNone) {
  EXPECT_NE(problem("").find("./run demo"), std::string::npos);
  EXPECT_NE(problem("/nowhere/a.db").find("./run learn"), std::string::npos);
}

}  // namespace
}  // namespace hexapod
