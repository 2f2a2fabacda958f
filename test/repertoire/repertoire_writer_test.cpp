#include "repertoire/repertoire_writer.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "fixtures.h"

namespace hexapod {
namespace {

bool mentions(const std::string& sentence, const std::string& words) {
  return sentence.find(words) != std::string::npos;
}

TEST(RepertoireWriter, CreatesTheFoldersItNeeds) {
  const TemporaryFolder folder;
  saveRepertoire(folder.file("a/b/c.db"), sampleRepertoire());
  EXPECT_EQ(loadRepertoire(folder.file("a/b/c.db")).entries.size(), 40U);
}

TEST(RepertoireWriter, SaysWhyAFolderCannotBeCreated) {
  const TemporaryFolder folder;
  writeContent(folder.file("occupied"), "");
  const std::string file = folder.file("occupied/a.db");
  EXPECT_TRUE(mentions(complaintOf([&] { RepertoireWriter writer(file); }), "cannot be created"));
}

TEST(RepertoireWriter, ReplacesTheWholeContentAtEachSave) {
  const TemporaryFolder folder;
  RepertoireWriter writer(folder.file("a.db"));
  EXPECT_FALSE(writer.holdsRepertoire());
  writer.save(sampleRepertoire(40), {{{"key", "old"}}, {}, {}, {}});
  EXPECT_TRUE(writer.holdsRepertoire());
  EXPECT_EQ(loadRepertoire(folder.file("a.db")).entries.size(), 40U);
  writer.save(sampleRepertoire(30), {{{"other", "new"}}, {}, {}, {}});
  EXPECT_EQ(loadRepertoire(folder.file("a.db")).entries.size(), 30U);
  const std::map<std::string, std::string> saved{{"other", "new"}};
  EXPECT_EQ(loadLearnerState(folder.file("a.db")).values, saved);
}

TEST(RepertoireWriter, LeavesNoFileThatItCreatedAndInWhichNothingWasSaved) {
  const TemporaryFolder folder;
  { const RepertoireWriter writer(folder.file("a.db")); }
  EXPECT_FALSE(std::filesystem::exists(folder.file("a.db")));
  writeContent(folder.file("empty.db"), "");
  { const RepertoireWriter writer(folder.file("empty.db")); }
  EXPECT_TRUE(std::filesystem::exists(folder.file("empty.db")));
}

TEST(RepertoireWriter, FindsTheRepertoireOfAnEarlierRun) {
  const TemporaryFolder folder;
  saveRepertoire(folder.file("a.db"), sampleRepertoire());
  EXPECT_TRUE(RepertoireWriter(folder.file("a.db")).holdsRepertoire());
}

TEST(RepertoireWriter, ASecondOneIsRefusedNamingTheFirstUntilThatIsGone) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.db");
  {
    const RepertoireWriter first(file);
    const std::string sentence = complaintOf([&] { RepertoireWriter second(file); });
    EXPECT_TRUE(mentions(sentence, file)) << sentence;
    EXPECT_TRUE(mentions(sentence, "process " + std::to_string(::getpid()) + " on ")) << sentence;
  }
  EXPECT_EQ(complaintOf([&] { RepertoireWriter second(file); }), "");
}

TEST(RepertoireWriter, ALockLeftByAKilledProcessIsInNobodysWay) {
  const TemporaryFolder folder;
  writeContent(folder.file("a.db.lock"), "process 1 on nowhere\n");
  EXPECT_EQ(complaintOf([&] { RepertoireWriter writer(folder.file("a.db")); }), "");
}

TEST(RepertoireWriter, NeverOverwritesWhatIsNotARepertoire) {
  const TemporaryFolder folder;
  const std::string file = folder.file("thesis.txt");
  writeContent(file, std::string(3000, 't'));
  EXPECT_NE(complaintOf([&] { saveRepertoire(file, sampleRepertoire()); }), "");
  EXPECT_EQ(contentOf(file), std::string(3000, 't'));

  const std::string foreign = folder.file("foreign.db");
  SqliteDatabase(foreign, SqliteDatabase::Mode::kCreate).execute("CREATE TABLE mail(text)");
  const std::string before = contentOf(foreign);
  EXPECT_TRUE(mentions(complaintOf([&] { saveRepertoire(foreign, sampleRepertoire()); }),
                       "another program's"));
  EXPECT_EQ(contentOf(foreign), before);
}

TEST(RepertoireWriter, NeverWritesThroughALinkNorOverAFolder) {
  const TemporaryFolder folder;
  writeContent(folder.file("target"), "");
  std::filesystem::create_symlink(folder.file("target"), folder.file("link.db"));
  EXPECT_NE(complaintOf([&] { saveRepertoire(folder.file("link.db"), sampleRepertoire()); }), "");
  EXPECT_EQ(contentOf(folder.file("target")), "");
  std::filesystem::create_directory(folder.file("folder"));
  EXPECT_NE(complaintOf([&] { saveRepertoire(folder.file("folder"), sampleRepertoire()); }), "");
  EXPECT_NE(complaintOf([&] { saveRepertoire("", sampleRepertoire()); }), "");
}

TEST(RepertoireWriter, ReplacesAFileOfAnotherVersionOnlyWhenItIsMovedAway) {
  const TemporaryFolder folder;
  saveRepertoire(folder.file("a.db"), sampleRepertoire());
  SqliteDatabase(folder.file("a.db"), SqliteDatabase::Mode::kWrite)
      .execute("PRAGMA user_version = 1");
  EXPECT_TRUE(
      mentions(complaintOf([&] { saveRepertoire(folder.file("a.db"), {}); }), "format version 1"));
}

TEST(RepertoireWriter, MakesAFileOfVersion2OneOfItsOwn) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.db");
  saveRepertoire(file, sampleRepertoire(5), {{{"population", "1 1 0123 fell"}}, {}, {}, {}});
  SqliteDatabase(file, SqliteDatabase::Mode::kWrite)
      .execute("DROP TABLE population; DROP TABLE archive; PRAGMA user_version = 2");
  EXPECT_EQ(loadLearnerState(file).values.at("population"), "1 1 0123 fell");
  EXPECT_EQ(loadRepertoire(file).entries.size(), 5U);
  saveRepertoire(file, sampleRepertoire(6));
  EXPECT_EQ(loadRepertoire(file).entries.size(), 6U);
  EXPECT_EQ(SqliteDatabase(file, SqliteDatabase::Mode::kRead).integer("PRAGMA user_version"),
            kFormatVersion);
}

TEST(RepertoireWriter, GoesOnWhenItsFileOrFolderWasRemoved) {
  const TemporaryFolder folder;
  RepertoireWriter writer(folder.file("sub/a.db"));
  writer.save(sampleRepertoire());
  std::filesystem::remove_all(folder.file("sub"));
  writer.save(sampleRepertoire());
  EXPECT_EQ(loadRepertoire(folder.file("sub/a.db")).entries.size(), 40U);
}

/// Another run's repertoire, which is not to be lost.
Repertoire another() {
  Repertoire repertoire = sampleRepertoire(7);
  repertoire.run_id = "another";
  return repertoire;
}

void expectRefusedUntilMovedAway(RepertoireWriter& writer, const std::string& file) {
  const std::string before = contentOf(file);
  for (int tries = 0; tries < 2; ++tries) {
    const std::string sentence = complaintOf([&] { writer.save(sampleRepertoire()); });
    EXPECT_TRUE(mentions(sentence, file) && mentions(sentence, "not overwritten")) << sentence;
  }
  EXPECT_EQ(contentOf(file), before);
  std::filesystem::rename(file, file + ".away");
  writer.save(sampleRepertoire());
  EXPECT_EQ(loadRepertoire(file).run_id, "run-11");
  EXPECT_EQ(loadRepertoire(file + ".away").run_id, "another");
}

TEST(RepertoireWriter, DoesNotOverwriteAFileThatTookThePlaceOfItsOwn) {
  const TemporaryFolder folder;
  saveRepertoire(folder.file("other.db"), another());
  RepertoireWriter writer(folder.file("a.db"));
  writer.save(sampleRepertoire());
  std::filesystem::rename(folder.file("other.db"), folder.file("a.db"));
  expectRefusedUntilMovedAway(writer, folder.file("a.db"));
}

TEST(RepertoireWriter, DoesNotOverwriteAFileThatCameBeforeItsFirstSave) {
  const TemporaryFolder folder;
  saveRepertoire(folder.file("other.db"), another());
  RepertoireWriter writer(folder.file("a.db"));
  std::filesystem::rename(folder.file("other.db"), folder.file("a.db"));
  expectRefusedUntilMovedAway(writer, folder.file("a.db"));
}

TEST(RepertoireWriter, DoesNotOverwriteWhatSomebodyElseWroteIntoItsFile) {
  const TemporaryFolder folder;
  saveRepertoire(folder.file("other.db"), another());
  RepertoireWriter writer(folder.file("a.db"));
  writer.save(sampleRepertoire());
  std::ofstream(folder.file("a.db"), std::ios::binary) << contentOf(folder.file("other.db"));
  expectRefusedUntilMovedAway(writer, folder.file("a.db"));
}

TEST(RepertoireWriter, LeavesAFileThatWasMovedAndBeginsAnother) {
  const TemporaryFolder folder;
  RepertoireWriter writer(folder.file("a.db"));
  writer.save(another());
  std::filesystem::rename(folder.file("a.db"), folder.file("b.db"));
  writer.save(sampleRepertoire());
  EXPECT_EQ(loadRepertoire(folder.file("a.db")).run_id, "run-11");
  EXPECT_EQ(loadRepertoire(folder.file("b.db")).run_id, "another");
}

TEST(RepertoireWriter, GoesOnWithAFileThatWasOnlyTouched) {
  const TemporaryFolder folder;
  RepertoireWriter writer(folder.file("a.db"));
  writer.save(another());
  std::filesystem::last_write_time(folder.file("a.db"), {});
  writer.save(sampleRepertoire());
  EXPECT_EQ(loadRepertoire(folder.file("a.db")).run_id, "run-11");
}

TEST(RepertoireWriter, ASecondNameOfALockedFileIsRefused) {
  const TemporaryFolder folder;
  RepertoireWriter writer(folder.file("a.db"));
  writer.save(another());
  std::filesystem::create_hard_link(folder.file("a.db"), folder.file("b.db"));
  const std::string sentence = complaintOf([&] { RepertoireWriter(folder.file("b.db")); });
  EXPECT_TRUE(mentions(sentence, "hard links") && mentions(sentence, "copy")) << sentence;
  writer.save(sampleRepertoire());
  EXPECT_EQ(loadRepertoire(folder.file("a.db")).run_id, "run-11");
}

TEST(RepertoireWriter, ARefusedSaveLeavesTheLastGoodContent) {
  const TemporaryFolder folder;
  RepertoireWriter writer(folder.file("a.db"));
  writer.save(sampleRepertoire());
  Repertoire spoilt = sampleRepertoire();
  spoilt.entries[1].id = spoilt.entries[0].id;
  EXPECT_THROW(writer.save(spoilt), std::invalid_argument);
  EXPECT_EQ(loadRepertoire(folder.file("a.db")).entries.size(), 40U);
}

TEST(RepertoireWriter, AReaderDuringASaveSeesTheLastGoodContent) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.db");
  saveRepertoire(file, sampleRepertoire());
  SqliteDatabase writing(file, SqliteDatabase::Mode::kWrite);
  const SqliteTransaction transaction(writing, SqliteTransaction::Kind::kWrite);
  writing.execute("DELETE FROM entries");
  EXPECT_EQ(loadRepertoire(file).entries.size(), 40U);
}

/// Saves, then starts another save whose changes reach the disk, and dies in the midst of it.
[[noreturn]] void dieWhileSaving(const std::string& file) {
  saveRepertoire(file, sampleRepertoire(2000));
  SqliteDatabase writing(file, SqliteDatabase::Mode::kWrite);
  writing.execute("PRAGMA cache_size = 1");
  writing.execute("BEGIN IMMEDIATE");
  writing.execute("UPDATE entries SET x_m = 0.0; DELETE FROM meta");
  ::_exit(0);
}

TEST(RepertoireWriter, AProcessKilledWhileSavingLeavesTheCheckpointBefore) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.db");
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) dieWhileSaving(file);
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(std::filesystem::exists(file + "-journal"));
  EXPECT_EQ(digestOf(loadRepertoire(file).entries), digestOf(sampleRepertoire(2000).entries));
  EXPECT_EQ(complaintOf([&] { saveRepertoire(file, sampleRepertoire()); }), "");
}

}  // namespace
}  // namespace hexapod
