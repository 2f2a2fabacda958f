#include "study/study_folder.h"

#include <fstream>
#include <set>
#include <stdexcept>
#include <system_error>

#include "common/text.h"
#include "repertoire/file_lock.h"
#include "study/run_files.h"

namespace hexapod {
namespace {

namespace fs = std::filesystem;

/// What follows "<algorithm>_<seed>_" in the name of a run, as a number; -1 for other names.
std::int64_t evaluationsOf(const std::string& name, const RunPlan& plan) {
  const std::string start = plan.algorithm + "_" + std::to_string(plan.seed) + "_";
  if (name.rfind(start, 0) != 0) return -1;
  return integerFromText(name.substr(start.size())).value_or(-1);
}

}  // namespace

StudyFolder::StudyFolder(const std::string& path) : path_(path) {
  std::error_code error;
  fs::create_directories(path_, error);
  if (fs::is_directory(path_)) return;
  throw std::runtime_error("The folder " + path +
                           " of the study cannot be made: " + error.message() + ".");
}

bool StudyFolder::isDone(const RunPlan& plan) const {
  for (const fs::path& run : finishedRuns()) {
    if (evaluationsOf(run.filename().string(), plan) >= plan.evaluations) return true;
  }
  return false;
}

StudyFolder::Claim StudyFolder::perform(const RunPlan& plan,
                                        const std::function<void(const std::string&)>& run) {
  const fs::path unfinished = path_ / (".unfinished_" + plan.name());
  try {
    const FileLock claim(unfinished.string());
    if (isDone(plan)) return Claim::kTaken;
    fs::remove_all(unfinished);
    fs::create_directory(unfinished);
    run(unfinished.string());
    fs::rename(unfinished, folderOf(plan));
    fs::remove(failureOf(plan));
    return Claim::kPerformed;
  } catch (const FileTaken&) {
    return Claim::kTaken;
  } catch (const std::exception& error) {
    noteFailure(plan, error.what());
    throw;
  }
}

void StudyFolder::noteFailure(const RunPlan& plan, const std::string& reason) const {
  std::ofstream(failureOf(plan)) << reason << '\n';
}

void StudyFolder::requireSameOptions(const std::map<std::string, std::string>& options) const {
  for (const fs::path& run : finishedRuns()) {
    const std::map<std::string, std::string> facts = readRunFacts((run / "run.csv").string());
    std::string differences;
    for (const auto& [name, text] : options) {
      const auto found = facts.find(name);
      const std::string there = found == facts.end() ? "not told" : found->second;
      if (there != text) differences += "\n  " + name + ": " + there + " there, " + text + " now";
    }
    if (differences.empty()) continue;
    throw std::invalid_argument("The run in " + run.string() +
                                " was made with other options; give the same ones, or another "
                                "folder:" +
                                differences);
  }
}

std::vector<fs::path> StudyFolder::finishedRuns() const {
  std::set<fs::path> runs;
  std::error_code error;
  for (const fs::directory_entry& item : fs::directory_iterator(path_, error)) {
    if (fs::is_regular_file(item.path() / "run.csv", error)) runs.insert(item.path());
  }
  for (auto run = runs.begin(); run != runs.end();) {
    run = run->filename().string().rfind('.', 0) == 0 ? runs.erase(run) : std::next(run);
  }
  return {runs.begin(), runs.end()};
}

fs::path StudyFolder::failureOf(const RunPlan& plan) const {
  return path_ / (plan.name() + ".failed");
}

}  // namespace hexapod
