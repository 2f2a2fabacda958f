#include "repertoire/repertoire_csv.h"

#include <gtest/gtest.h>

#include <sstream>

#include "fixtures.h"

namespace hexapod {
namespace {

TEST(ExportCsv, WritesOneLinePerEntryByIdAndLeavesOutWhatIsNotKnown) {
  Repertoire repertoire;
  Entry second;
  second.id = 2;
  second.genome = {0, 1, 2, 3, 4, 0, 0, 0};
  // Straight back, so that the arc arrives with heading 0.
  second.end_pose = {-0.5, 0.0, -0.125};
  second.cost = 1.5;
  second.evaluation = 1234;
  Entry first = second;
  first.id = 1;
  first.execution = Execution{{0.25, 0.0, -1.0}, 0.5, 2.0, 8, 1};
  repertoire.entries = {second, first};
  std::ostringstream out;
  exportCsv(repertoire, out);
  EXPECT_EQ(out.str(),
            "id,genome,x_m,y_m,yaw_rad,orientation_error_rad,cost,evaluation,executed_x_m,"
            "executed_y_m,executed_yaw_rad,spread_m,spread_rad,trials,falls\n"
            "1,01234000,-0.5,0,-0.125,0.125,1.5,1234,0.25,0,-1,0.5,2,8,1\n"
            "2,01234000,-0.5,0,-0.125,0.125,1.5,1234,,,,,,0,0\n");
}

TEST(ExportCsv, WritesGenomesThatReadBackWhateverTheirLevels) {
  Repertoire repertoire;
  repertoire.options["gene_levels"] = "253";
  Entry entry;
  entry.id = 1;
  entry.genome = {0, 252, 17, 126};
  repertoire.entries = {entry};
  std::ostringstream out;
  exportCsv(repertoire, out);
  const std::string text = out.str();
  EXPECT_NE(text.find("\n1,x00fc117e,"), std::string::npos) << text;
  EXPECT_EQ(genomeFromString("x00fc117e"), entry.genome);
}

TEST(ExportCsv, IsTheSameInEveryLocale) {
  std::ostringstream plain;
  exportCsv(sampleRepertoire(), plain);
  const CommaLocale comma;
  std::ostringstream other;
  exportCsv(sampleRepertoire(), other);
  EXPECT_EQ(plain.str(), other.str());
}

}  // namespace
}  // namespace hexapod
