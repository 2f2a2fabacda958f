#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "study/run_plan.h"

namespace hexapod {

/// Where a study keeps its runs: a sub-folder for each that is finished, named by the plan.
///
/// Any number of processes, on any number of machines that share the file system, may work in one
/// folder: each run is done by the process that claims it. A run is made under another name and
/// renamed in the end, so whatever is killed leaves either the whole run or nothing.
class StudyFolder {
 public:
  /// Makes the folder when there is none. Throws std::runtime_error when that fails.
  explicit StudyFolder(const std::string& path);

  /// True when the folder has the plan's run, or one of more candidates with the same algorithm and
  /// seed: it went through the plan's.
  bool isDone(const RunPlan& plan) const;

  /// How perform() ended.
  enum class Claim { kPerformed, kTaken };

  /// Calls `run` with an empty folder to write the run's files into and keeps it as the plan's;
  /// an earlier failure is forgotten. Does nothing, and says so, when another process is at it or
  /// it is done. What `run` throws is kept as the run's failure and passed on.
  Claim perform(const RunPlan& plan, const std::function<void(const std::string&)>& run);

  /// Notes that the plan's run failed.
  void noteFailure(const RunPlan& plan, const std::string& reason) const;

  /// Throws std::invalid_argument naming every option in which the finished runs' files differ from
  /// `options` (run.csv's texts by name): what is in one folder is compared, so it must be alike.
  void requireSameOptions(const std::map<std::string, std::string>& options) const;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::vector<std::filesystem::path> finishedRuns() const;
  std::filesystem::path folderOf(const RunPlan& plan) const { return path_ / plan.name(); }
  std::filesystem::path failureOf(const RunPlan& plan) const;

  std::filesystem::path path_;
};

}  // namespace hexapod
