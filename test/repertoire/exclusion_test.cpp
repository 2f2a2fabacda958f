#include "repertoire/exclusion.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "repertoire/fixtures.h"
#include "repertoire/repertoire_file.h"
#include "repertoire/repertoire_writer.h"

namespace hexapod {
namespace {

TEST(Exclusion, TheFileKeepsWhatIsNotToBeUsedAndTheRest) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.db");
  Repertoire repertoire = sampleRepertoire(5);
  setExcluded(repertoire, 4, true);
  setExcluded(repertoire, 2, true);
  setExcluded(repertoire, 2, true);
  saveRepertoire(file, repertoire);
  Repertoire loaded = loadRepertoire(file);
  EXPECT_EQ(loaded.entries.size(), 5u);
  EXPECT_EQ(excludedIds(loaded), (std::set<std::int64_t>{2, 4}));
  std::vector<std::int64_t> used;
  for (const Entry& entry : withoutExcluded(loaded).entries) used.push_back(entry.id);
  EXPECT_EQ(used, (std::vector<std::int64_t>{1, 3, 5}));
  setExcluded(loaded, 2, false);
  setExcluded(loaded, 4, false);
  EXPECT_TRUE(excludedIds(loaded).empty());
  EXPECT_EQ(loaded.facts, sampleRepertoire(5).facts);
}

TEST(Exclusion, AnEntryThatIsNotThereIsNamed) {
  Repertoire repertoire = sampleRepertoire(5);
  EXPECT_NE(complaintOf([&] { setExcluded(repertoire, 77, true); }).find("no entry 77"),
            std::string::npos);
  EXPECT_TRUE(excludedIds(repertoire).empty());
}

}  // namespace
}  // namespace hexapod
