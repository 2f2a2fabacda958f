#include <gtest/gtest.h>

#include <limits>

#include "fixtures.h"
#include "repertoire/repertoire_writer.h"
#include "repertoire/sqlite.h"

namespace hexapod {
namespace {

/// A saved sample that tests spoil.
class DamagedFile : public ::testing::Test {
 protected:
  DamagedFile() : file_(folder_.file("walks.db")) { saveRepertoire(file_, sampleRepertoire()); }

  std::string complaint() const {
    return complaintOf([&] { loadRepertoire(file_); });
  }
  void edit(const std::string& sql) {
    SqliteDatabase(file_, SqliteDatabase::Mode::kWrite).execute(sql);
  }
  /// Expects a sentence with the file's name and all of these words.
  void expectComplaint(const std::vector<std::string>& words) const {
    const std::string sentence = complaint();
    EXPECT_NE(sentence.find(file_), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("expected"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("found"), std::string::npos) << sentence;
    for (const std::string& word : words) {
      EXPECT_NE(sentence.find(word), std::string::npos) << word << " in: " << sentence;
    }
  }

  TemporaryFolder folder_;
  std::string file_;
};

TEST_F(DamagedFile, AMissingOneIsRefusedAndNotCreated) {
  std::filesystem::remove(file_);
  expectComplaint({"no such file"});
  EXPECT_FALSE(std::filesystem::exists(file_));
}

TEST_F(DamagedFile, AnEmptyOneIsRefused) {
  writeContent(file_, "");
  expectComplaint({"empty"});
}

TEST_F(DamagedFile, AFolderIsRefused) {
  std::filesystem::remove(file_);
  std::filesystem::create_directory(file_);
  expectComplaint({"folder"});
}

TEST_F(DamagedFile, GarbageIsRefused) {
  writeContent(file_, "id,genome\n1,0123\n");
  expectComplaint({"another kind"});
  writeContent(file_, std::string("SQLite format 3\0", 16) + std::string(5000, 'x'));
  EXPECT_NE(complaint(), "");
}

TEST_F(DamagedFile, ATruncatedOneIsRefusedWhereverItEnds) {
  const std::string whole = contentOf(file_);
  for (std::size_t length = 0; length < whole.size(); length += 97) {
    writeContent(file_, whole.substr(0, length));
    ASSERT_NE(complaint(), "") << "cut to " << length << " of " << whole.size();
  }
  writeContent(file_, whole.substr(0, whole.size() - 1));
  expectComplaint({"cut short", std::to_string(whole.size())});
}

TEST_F(DamagedFile, AFlippedByteIsRefusedOrWithoutEffect) {
  const std::string whole = contentOf(file_);
  const std::string digest = digestOf(sampleRepertoire().entries);
  int refused = 0;
  for (std::size_t position = 0; position < whole.size(); position += 31) {
    std::string damaged = whole;
    damaged[position] = static_cast<char>(damaged[position] ^ 0x40);
    writeContent(file_, damaged);
    try {
      const StoredRepertoire stored = loadStoredRepertoire(file_);
      ASSERT_EQ(digestOf(stored.repertoire.entries), digest) << "byte " << position;
      ASSERT_EQ(stored.repertoire.run_id, "run-11") << "byte " << position;
      ASSERT_EQ(stored.repertoire.options, sampleRepertoire().options) << "byte " << position;
    } catch (const std::runtime_error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 100);
}

TEST_F(DamagedFile, AnotherProgramsDatabaseIsRefused) {
  edit("PRAGMA application_id = 42");
  expectComplaint({"application id 42"});
}

TEST_F(DamagedFile, OtherFormatVersionsAreRefused) {
  for (const int version : {0, 4, 99}) {
    edit("PRAGMA user_version = " + std::to_string(version));
    expectComplaint({"format version 1 to 3", "version " + std::to_string(version)});
  }
}

TEST_F(DamagedFile, AMissingTableColumnOrRowIsNamed) {
  edit("DELETE FROM meta WHERE key = 'robot_id'");
  expectComplaint({});
  edit("ALTER TABLE entries RENAME COLUMN yaw_rad TO heading");
  expectComplaint({"yaw_rad"});
  edit("DROP TABLE history");
  expectComplaint({"history"});
}

TEST_F(DamagedFile, IllegalRowsOfALearnerAreNamed) {
  const std::string whole = contentOf(file_);
  const std::vector<std::pair<std::string, std::string>> spoilt = {
      {"INSERT INTO population VALUES (1, 1, '01', 'flew', 0.0, 0.0, 0.0, 0.0, 0, 0.0, 1)",
       "'flew'"},
      {"INSERT INTO population VALUES (1, 1, '!', 'fell', 0.0, 0.0, 0.0, 0.0, 0, 0.0, 1)",
       "genome"},
      {"INSERT INTO archive VALUES (1, '01', 'far', 0.0, 0.0, 0.0, 1, 0)", "table archive"},
      {"DROP TABLE archive", "table archive"}};
  for (const auto& [sql, word] : spoilt) {
    writeContent(file_, whole);
    edit(sql);
    expectComplaint({word});
  }
}

TEST_F(DamagedFile, AViewInThePlaceOfATableIsRefused) {
  edit(
      "DROP TABLE state; CREATE VIEW state AS WITH RECURSIVE n(key) AS (SELECT 1 UNION ALL "
      "SELECT key + 1 FROM n) SELECT key, '' AS value FROM n");
  expectComplaint({"state"});
}

TEST_F(DamagedFile, IllegalGenesAreNamed) {
  edit("UPDATE entries SET genome = '012345' || substr(genome, 7) WHERE id = 7");
  expectComplaint({"entry 7", "level 5", "0 to 4"});
  edit("UPDATE entries SET genome = 'x0g' WHERE id = 7");
  expectComplaint({"entry 7", "genome", "'x0g'", "hexadecimal"});
}

TEST_F(DamagedFile, AWrongNumberOfGenesIsNamed) {
  edit("UPDATE entries SET genome = '0123' WHERE id = 8");
  expectComplaint({"entry 8", "4 genes", "24"});
  edit("UPDATE meta SET value = '4000000000' WHERE key = 'gene_count'");
  expectComplaint({"4000000000"});
}

TEST_F(DamagedFile, LevelsThatAreNoNumberAreNamed) {
  for (const char* levels : {"many", "0", "257", ""}) {
    edit(std::string("INSERT OR REPLACE INTO meta VALUES ('option.gene_levels', '") + levels +
         "')");
    expectComplaint({"gene_levels", std::string("'") + levels + "'"});
  }
}

TEST_F(DamagedFile, PosesThatAreNotFiniteAreNamed) {
  edit("UPDATE entries SET y_m = 9e999 WHERE id = 9");
  expectComplaint({"entry 9", "not finite"});
}

TEST_F(DamagedFile, AWrongTypeIsNamed) {
  edit("UPDATE entries SET x_m = 'far' WHERE id = 5");
  expectComplaint({"entry 5", "number"});
}

TEST_F(DamagedFile, ImpossibleTrialsAreNamed) {
  edit("UPDATE entries SET falls = 9 WHERE id = 4");
  expectComplaint({"entry 4", "9 falls in 8 trials"});
}

TEST_F(DamagedFile, DuplicateIdsAndGenomesAreNamed) {
  edit(
      "CREATE TABLE loose AS SELECT * FROM entries; DROP TABLE entries;"
      "ALTER TABLE loose RENAME TO entries; UPDATE entries SET genome = (SELECT genome FROM "
      "entries WHERE id = 1) WHERE id = 3");
  expectComplaint({"entry 3", "genome"});
  edit("UPDATE entries SET id = 2 WHERE id = 3");
  expectComplaint({"entry 2 twice"});
}

TEST_F(DamagedFile, EditedContentDoesNotMatchItsDigest) {
  edit("UPDATE entries SET x_m = x_m + 0.001 WHERE id = 1");
  expectComplaint({"digest", "damaged or edited"});
}

TEST_F(DamagedFile, EditedMetaHistoryOrStateDoesNotMatchItsDigest) {
  const std::string whole = contentOf(file_);
  for (const char* sql :
       {"UPDATE meta SET value = '5' WHERE key = 'seed'", "UPDATE history SET elapsed_s = 0.5",
        "INSERT INTO state VALUES ('random', x'00')",
        "INSERT INTO population VALUES (1, 1, '01', 'fell', 0.0, 0.0, 0.0, 0.0, 0, 0.0, 1)",
        "INSERT INTO archive VALUES (1, '01', 0.0, 0.0, 0.0, 0.0, 1, 0)",
        "UPDATE trials SET measured_x_m = 0.25 WHERE evaluation = 100", "DROP TABLE trials",
        "DELETE FROM meta WHERE key = 'option.seed'"}) {
    writeContent(file_, whole);
    edit(sql);
    expectComplaint({"digest"});
  }
}

TEST_F(DamagedFile, NothingThatCouldNotBeLoadedIsSaved) {
  const auto spoilt = [&](auto spoil) {
    Repertoire repertoire = sampleRepertoire();
    spoil(repertoire.entries[6]);
    const std::string sentence = complaintOf([&] { saveRepertoire(file_, repertoire); });
    EXPECT_NE(sentence.find("entry"), std::string::npos) << sentence;
  };
  spoilt([](Entry& entry) { entry.genome[3] = 5; });
  spoilt([](Entry& entry) { entry.genome.pop_back(); });
  spoilt([](Entry& entry) { entry.id = 1; });
  spoilt([](Entry& entry) { entry.genome = sampleRepertoire().entries[0].genome; });
  spoilt([](Entry& entry) { entry.end_pose.x_m = std::numeric_limits<double>::quiet_NaN(); });
  spoilt([](Entry& entry) { entry.cost = -1.0; });
  spoilt([](Entry& entry) { entry.execution = Execution{{0, 0, 0}, -1.0, 0.0, 2, 0}; });
  EXPECT_EQ(complaint(), "");
}

TEST_F(DamagedFile, NoTrialThatCouldNotBeLoadedIsSaved) {
  const auto spoilt = [&](auto spoil) {
    Repertoire repertoire = sampleRepertoire();
    spoil(repertoire.trials[1]);
    const std::string sentence = complaintOf([&] { saveRepertoire(file_, repertoire); });
    EXPECT_NE(sentence.find("trial"), std::string::npos) << sentence;
  };
  spoilt([](RobotTrial& trial) { trial.genome[3] = 5; });
  spoilt([](RobotTrial& trial) { trial.genome.pop_back(); });
  spoilt([](RobotTrial& trial) { trial.cost = -1.0; });
  spoilt([](RobotTrial& trial) {
    trial.measured = Pose2{std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0};
  });
  EXPECT_EQ(complaint(), "");
}

}  // namespace
}  // namespace hexapod
