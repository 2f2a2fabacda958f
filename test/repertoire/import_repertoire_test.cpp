#include "repertoire/import_repertoire.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "fixtures.h"
#include "repertoire/repertoire_file.h"
#include "repertoire/repertoire_writer.h"

namespace hexapod {
namespace {

Repertoire fromCsv(const std::string& text, const ImportOptions& options = {}) {
  std::istringstream in(text);
  return importCsv(in, "steps.csv", options);
}

Repertoire fromPrimitives(const std::string& text) {
  std::istringstream in(text);
  return importPrimitives(in, "steps.mprim");
}

template <typename Function>
std::string refusalOf(Function&& function) {
  try {
    function();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

// Two primitives of start angle 0 and one of another, as SBPL's generators write them.
constexpr const char* kPrimitives =
    "resolution_m: 0.025000\n"
    "numberofangles: 16\n"
    "totalnumberofprimitives: 3\n"
    "primID: 0\nstartangle_c: 0\nendpose_c: 1 0 0\nadditionalactioncostmult: 1\n"
    "intermediateposes: 2\n0.0000 0.0000 0.0000\n0.0250 0.0000 0.0000\n"
    "primID: 1\nstartangle_c: 0\nendpose_c: 8 1 1\nadditionalactioncostmult: 2\n"
    "intermediateposes: 3\n0.0 0.0 0.0\n0.1 0.01 0.2\n0.2000 0.0250 0.3927\n"
    "primID: 0\nstartangle_c: 1\nendpose_c: 2 1 1\nadditionalactioncostmult: 1\n"
    "intermediateposes: 1\n0.05 0.025 0.3927\n";

TEST(ImportCsv, ReadsNamedColumnsInAnyOrderAndLeavesOthersOut) {
  const Repertoire repertoire = fromCsv("name,dyaw,dx,dy\nleft,0.5,0.1,0.2\n\"back\",0,-0.3,0\n");
  ASSERT_EQ(repertoire.entries.size(), 2u);
  EXPECT_EQ(repertoire.entries[0].end_pose.x_m, 0.1);
  EXPECT_EQ(repertoire.entries[0].end_pose.y_m, 0.2);
  EXPECT_EQ(repertoire.entries[0].end_pose.yaw_rad, 0.5);
  EXPECT_EQ(repertoire.entries[1].end_pose.x_m, -0.3);
  EXPECT_NE(repertoire.entries[0].id, repertoire.entries[1].id);
}

TEST(ImportCsv, ReadsTheFirstThreeColumnsWithoutAHeaderInTheUnitsGiven) {
  ImportOptions options;
  options.length_unit = "cm";
  options.angle_unit = "deg";
  const Repertoire repertoire = fromCsv("# comment\n10,20,90\n\n", options);
  ASSERT_EQ(repertoire.entries.size(), 1u);
  EXPECT_NEAR(repertoire.entries[0].end_pose.x_m, 0.1, 1e-12);
  EXPECT_NEAR(repertoire.entries[0].end_pose.y_m, 0.2, 1e-12);
  EXPECT_NEAR(repertoire.entries[0].end_pose.yaw_rad, M_PI / 2.0, 1e-12);
}

TEST(ImportCsv, NamesTheLineThatIsWrong) {
  EXPECT_EQ(refusalOf([] { fromCsv("dx,dy,dyaw\n0.1,0,0\n0.1,zero,0\n"); }),
            "steps.csv, line 3: expected a finite number in column 2, found 'zero'.");
  EXPECT_NE(refusalOf([] { fromCsv("dx,dy,dyaw\n0.1,nan,0\n"); }).find("line 2"),
            std::string::npos);
  EXPECT_NE(refusalOf([] { fromCsv("0.1,0.2\n"); }).find("column 3"), std::string::npos);
  EXPECT_NE(refusalOf([] { fromCsv("x,y,theta\n1,2,3\n"); }).find("dx, dy and dyaw"),
            std::string::npos);
  EXPECT_NE(refusalOf([] { fromCsv("dx,dy,dyaw\n"); }).find("no entries"), std::string::npos);
}

TEST(ImportPrimitives, TakesTheLastPoseOfThoseOfStartAngle0) {
  const Repertoire repertoire = fromPrimitives(kPrimitives);
  ASSERT_EQ(repertoire.entries.size(), 2u);
  EXPECT_EQ(repertoire.entries[0].end_pose.x_m, 0.025);
  EXPECT_EQ(repertoire.entries[1].end_pose.x_m, 0.2);
  EXPECT_EQ(repertoire.entries[1].end_pose.y_m, 0.025);
  EXPECT_EQ(repertoire.entries[1].end_pose.yaw_rad, 0.3927);
}

TEST(ImportPrimitives, NamesTheLineThatIsWrong) {
  EXPECT_NE(refusalOf([] { fromPrimitives("resolution_m: 0.1\nhello\n"); }).find("line 2"),
            std::string::npos);
  EXPECT_NE(refusalOf([] {
              fromPrimitives("primID: 0\nstartangle_c: 0\nintermediateposes: 2\n0 0 0\n");
            }).find("more intermediate poses"),
            std::string::npos);
}

TEST(ImportedRepertoire, IsTheSameAfterSavingAndLoadingAndKnownAsImported) {
  const TemporaryFolder folder;
  const std::string file = folder.file("imported.db");
  const Repertoire repertoire = fromPrimitives(kPrimitives);
  saveRepertoire(file, repertoire);
  const Repertoire loaded = loadRepertoire(file);
  EXPECT_TRUE(isImported(loaded));
  ASSERT_EQ(loaded.entries.size(), 2u);
  EXPECT_TRUE(loaded.entries[1].genome.empty());
  EXPECT_EQ(loaded.entries[1].end_pose.yaw_rad, 0.3927);
  EXPECT_EQ(loaded.facts.at("imported_from"), "steps.mprim");
}

}  // namespace
}  // namespace hexapod
