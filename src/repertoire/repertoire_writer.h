#pragma once

#include <memory>
#include <optional>
#include <string>

#include "repertoire/file_lock.h"
#include "repertoire/file_stamp.h"
#include "repertoire/repertoire_file.h"
#include "repertoire/sqlite.h"

namespace hexapod {

/// Writes one repertoire file, again and again, and keeps everybody else from writing it as long as
/// it lives. One thread at a time. Numbers and rows do not depend on the locale.
class RepertoireWriter {
 public:
  /// Claims the file, creating its folder when missing. Throws std::runtime_error with a sentence
  /// when another process writes it (naming that process), when it is a link of either kind, a
  /// folder, not a repertoire file or one of another format version (none is ever overwritten), or
  /// when folder or file cannot be created.
  explicit RepertoireWriter(const std::string& file);
  /// A file that it created and in which nothing was saved is removed.
  ~RepertoireWriter();
  RepertoireWriter(const RepertoireWriter&) = delete;
  RepertoireWriter& operator=(const RepertoireWriter&) = delete;

  /// True when the file holds a repertoire already: one found there, or one saved.
  bool holdsRepertoire() const { return holds_repertoire_; }

  /// Replaces the whole content in one transaction. Throws std::invalid_argument naming the entry
  /// when the repertoire could not be loaded again (see loadStoredRepertoire), std::runtime_error
  /// naming the file when it cannot be written (disk full, read-only); the last good content stays,
  /// and the next save tries afresh. A file that was removed or moved meanwhile is created anew;
  /// one that stands in its place, or that somebody else wrote, is not overwritten:
  /// std::runtime_error.
  void save(const Repertoire& repertoire, const LearnerState& learner_state = {});

 private:
  void open();
  void requireOwnFile();
  void write(const Repertoire& repertoire, const LearnerState& learner_state);

  std::string file_;
  std::unique_ptr<FileLock> lock_;
  std::unique_ptr<SqliteDatabase> database_;
  bool holds_repertoire_ = false;
  bool created_ = false;            // the file, which was not there when it was claimed
  std::optional<FileStamp> stamp_;  // of the file as this object left it
  std::string digest_;              // of its content then
};

/// A RepertoireWriter for one save.
void saveRepertoire(const std::string& file, const Repertoire& repertoire,
                    const LearnerState& learner_state = {});

}  // namespace hexapod
