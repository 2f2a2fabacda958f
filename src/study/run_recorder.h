#pragma once

#include <cstdint>
#include <fstream>
#include <string>

#include "study/methods.h"

namespace hexapod {

/// Writes what a run finds into the files history.csv and entries.csv of a folder.
///
/// History has a row per repertoire about every 5 % of the budget's decade, and at least every 500
/// candidates; all entries are written at 1 and 3 times each power of ten from 10,000 on. Where the
/// rows are depends on the candidates alone, so that a long run's files begin like a short one's.
class RunRecorder {
 public:
  /// Begins both files. `folder` must exist.
  explicit RunRecorder(const std::string& folder);

  /// To be called after every generation: writes what has become due.
  void record(const Method& method, std::int64_t simulations, double wall_s);

  /// Writes what has not been yet and closes the files. Throws std::runtime_error naming the folder
  /// when something could not be written.
  void finish(const Method& method, std::int64_t simulations, double wall_s);

 private:
  void writeHistory(const Method& method, std::int64_t simulations, double wall_s);
  void writeEntries(const Method& method);

  std::string folder_;
  std::ofstream history_;
  std::ofstream entries_;
  std::int64_t history_written_ = 0;  // candidates at the newest rows
  std::int64_t entries_written_ = 0;
};

/// The row of history that is due at so many candidates: the largest not above them.
std::int64_t historyMark(std::int64_t evaluations);

/// The snapshot that is due at so many candidates, 0: none yet.
std::int64_t snapshotMark(std::int64_t evaluations);

}  // namespace hexapod
