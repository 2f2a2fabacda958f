#include "tools/same_file.h"

#include <gtest/gtest.h>

#include "repertoire/fixtures.h"

namespace hexapod {
namespace {

namespace fs = std::filesystem;

TEST(SameFile, IsFoundHoweverItsPathIsSpelt) {
  const TemporaryFolder folder;
  fs::create_directory(folder.file("sub"));
  fs::create_directory_symlink(folder.file("sub"), folder.file("door"));
  const std::string file = folder.file("sub/a.db");
  for (const bool exists : {false, true}) {
    if (exists) writeContent(file, "x");
    for (const char* other : {"sub/a.db", "sub/../sub/./a.db", "door/a.db", "sub//a.db"}) {
      EXPECT_TRUE(isSameFile(file, folder.file(other))) << other << exists;
    }
    EXPECT_TRUE(isSameFile(file, fs::relative(file).string())) << exists;
    EXPECT_FALSE(isSameFile(file, folder.file("sub/b.db"))) << exists;
    EXPECT_FALSE(isSameFile(file, folder.file("a.db"))) << exists;
  }
}

TEST(SameFile, IsFoundBehindLinks) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.db");
  fs::create_symlink("a.db", folder.file("link.csv"));
  EXPECT_TRUE(isSameFile(file, folder.file("link.csv")));
  writeContent(file, "x");
  EXPECT_TRUE(isSameFile(file, folder.file("link.csv")));
  fs::create_hard_link(file, folder.file("hard.csv"));
  EXPECT_TRUE(isSameFile(file, folder.file("hard.csv")));
}

}  // namespace
}  // namespace hexapod
